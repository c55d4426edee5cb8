package enlightenment.plan;

import enlightenment.compiled.CompiledScene;
import enlightenment.compiled.NarrowChains;
import enlightenment.compiled.RefractingMedia;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.Method;
import java.util.ArrayList;
import java.util.List;

/**
 * Light of a scene that a method samples so rarely that the interval of the error may be too short. It follows from scene and method alone,
 * not from samples: where few of them find such light, those that were taken agree too well.
 */
final class UndersampledLight {
    private UndersampledLight() {}

    /** Such light, as the end of a sentence; empty if none is known. */
    static String of(Method method, CompiledScene scene) {
        if (scene.physical == null || !(method instanceof BuiltInMethod)) {
            return "";
        }
        List<String> found = new ArrayList<>();
        if (scene.isEver(NarrowChains::leadToSmallLights)) {
            found.add(
                    "few paths reach small lamps by two narrow lobes in a row, or a mirror or glass and a narrow lobe");
        }
        if (method == BuiltInMethod.LIGHT && scene.isEver(RefractingMedia::haveRoughBorders)) {
            found.add("few light paths leave a medium by a rough border towards the eye");
        }
        return String.join("; ", found);
    }
}
