package enlightenment.device;

import enlightenment.bvh.FloatSlabs;
import enlightenment.primitive.Primitive;
import enlightenment.world.CompiledScene;
import enlightenment.world.light.ClassicLight;
import java.util.BitSet;
import java.util.Optional;

/** Why no device can shade a scene. */
final class SceneRefusal {
    private static final int CAMERA_START = 18;

    private SceneRefusal() {}

    static Optional<String> of(CompiledScene scene) {
        if (scene.instants.length > 0) {
            return Optional.of("motion blur");
        }
        double[] camera = scene.camera.linearForm();
        if (camera == null) {
            return Optional.of("a panorama");
        }
        if (camera[CAMERA_START] < 0) {
            return Optional.of("an isometric view");
        }
        if (scene.cameraSolids.length > 0) {
            return Optional.of("an eye that may be inside of glass");
        }
        if (scene.primitives.length == 0) {
            return Optional.of("no objects");
        }
        if (!FloatSlabs.suits(scene.accelerator.bounds().maxAbs())) {
            return Optional.of("an extreme size");
        }
        Optional<String> found = ofPrimitives(scene).or(() -> ofLights(scene));
        return scene.physical == null ? found : found.or(() -> PhysicalRefusal.of(scene));
    }

    private static Optional<String> ofPrimitives(CompiledScene scene) {
        BitSet asked = new BitSet();
        for (int id = 0; id < scene.primitives.length; id++) {
            Primitive p = scene.primitives[id];
            if (p.isExtreme()) {
                return Optional.of("an object of extreme size");
            }
            // All of a kind have one, or none has.
            if (!asked.get(scene.kind[id]) && p.flatForm() == null) {
                return Optional.of("an object of the kind " + scene.kindNames.get(scene.kind[id]));
            }
            asked.set(scene.kind[id]);
        }
        return Optional.empty();
    }

    private static Optional<String> ofLights(CompiledScene scene) {
        for (ClassicLight light : scene.lights) {
            if (!light.lyingOn().isEmpty()) {
                return Optional.of("a light that lies on a surface");
            }
            if (light.surface != null && light.surface.isExtreme()) {
                return Optional.of("a light of extreme size");
            }
        }
        return Optional.empty();
    }
}
