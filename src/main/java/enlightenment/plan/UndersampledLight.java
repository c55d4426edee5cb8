package enlightenment.plan;

import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.Method;
import enlightenment.world.CompiledScene;
import enlightenment.world.PhysicalScene;
import enlightenment.world.check.NarrowChains;
import enlightenment.world.check.RefractingMedia;
import enlightenment.world.check.SmallReflections;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * Light of a scene that a method samples so rarely that the interval of the error may be too short. It follows from scene and method alone,
 * not from samples: where few of them find such light, those that were taken agree too well.
 */
final class UndersampledLight {
    private UndersampledLight() {}

    /** Such light, each as the end of a sentence; empty if none is known, as of methods from outside. */
    static List<String> of(Method method, CompiledScene scene) {
        List<String> found = new ArrayList<>();
        if (scene.physical == null || !(method instanceof BuiltInMethod)) {
            return found;
        }
        if (scene.isEver(UndersampledLight::reflectsSmallLights)) {
            found.add("few paths find small lamps "
                    + (method == BuiltInMethod.LIGHT ? "" : "and caustics ")
                    + "that are seen in mirrors or through glass");
        }
        if (scene.isEver(NarrowChains::leadToSmallLights)) {
            found.add(
                    "few paths reach small lamps by two narrow lobes in a row, or a mirror or glass and a narrow lobe");
        }
        if (method == BuiltInMethod.LIGHT && scene.isEver(RefractingMedia::haveRoughInterfaces)) {
            found.add("few light paths leave a medium by a rough interface towards the eye");
        }
        if (method != BuiltInMethod.LIGHT && scene.isEver(RefractingMedia::areLitBySmallLights)) {
            found.add("few paths find light of small lamps in media whose interface refracts"
                    + (method == BuiltInMethod.BIDIRECTIONAL
                            ? ""
                            : "; --method " + BuiltInMethod.BIDIRECTIONAL.word() + " finds more of it"));
        }
        return found;
    }

    /** Whether paths from the eye alone find lights in mirrors and smooth glass that are small as seen from there, or in the picture. */
    private static boolean reflectsSmallLights(CompiledScene moment) {
        PhysicalScene physical = moment.physical;
        if (!physical.showsMirrored) {
            return false;
        }
        return physical.hasCausticPass() && physical.caustics.hasSmallLights()
                || physical.maxBounces <= 1 && Arrays.stream(physical.lights).anyMatch(light -> !light.isPoint)
                || SmallReflections.mayBeThere(moment);
    }
}
