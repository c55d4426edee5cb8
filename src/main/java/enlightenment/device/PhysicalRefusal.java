package enlightenment.device;

import enlightenment.accel.PrimitiveList;
import enlightenment.emitter.ParallelogramLight;
import enlightenment.emitter.SphereLight;
import enlightenment.world.CompiledScene;
import enlightenment.world.PhysicalScene;
import enlightenment.world.light.PhysicalLight;
import enlightenment.world.material.SurfaceMaterial;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.Optional;
import java.util.Set;

/** Why no device can shade a scene of physical shading that could do it in classic shading. */
final class PhysicalRefusal {
    /** Occluders of a light that the kernel has bits for. */
    private static final int MOST_OCCLUDERS = 64;

    private PhysicalRefusal() {}

    static Optional<String> of(CompiledScene scene) {
        PhysicalScene physical = scene.physical;
        if (physical.hasScattering) {
            return Optional.of("a medium that scatters light");
        }
        if (physical.surroundings != null) {
            return Optional.of("surroundings that are not the same everywhere");
        }
        if (physical.hasMasks) {
            return Optional.of("surfaces with holes");
        }
        if (physical.hasDispersion) {
            return Optional.of("glass that disperses light");
        }
        if (physical.hasPartialGlass) {
            return Optional.of("glass that is opaque in part");
        }
        if (physical.hasRoughGlass) {
            return Optional.of("rough glass");
        }
        if (physical.hasStraightGlass) {
            return Optional.of("glass that does not turn rays, such as panes");
        }
        return ofMaterials(scene).or(() -> ofLights(physical));
    }

    private static Optional<String> ofMaterials(CompiledScene scene) {
        Set<SurfaceMaterial> asked = Collections.newSetFromMap(new IdentityHashMap<>());
        for (int id = 0; id < scene.primitives.length; id++) {
            for (int face = 0; face < scene.primitives[id].faceCount(); face++) {
                SurfaceMaterial material = scene.material(id, face);
                String why = asked.add(material) ? refusal(material) : null;
                if (why != null) {
                    return Optional.of(why);
                }
            }
        }
        return Optional.empty();
    }

    /** Null if the kernel knows the material. */
    private static String refusal(SurfaceMaterial material) {
        if (material.detail != null) {
            return "a material that differs from place to place";
        }
        if (material.reradiation != null) {
            return "a fluorescent material";
        }
        if (material.radianceMap != null) {
            return "a light with a texture";
        }
        return material.bsdf.flatForm() == null ? "a material that devices do not know in physical shading" : null;
    }

    private static Optional<String> ofLights(PhysicalScene physical) {
        for (PhysicalLight light : physical.lights) {
            if (light.profile != null) {
                return Optional.of("a light that shines differently in each direction");
            }
            boolean isKnown = light.isPoint
                    || light.form instanceof SphereLight
                    || light.form instanceof ParallelogramLight p && p.flatForm() != null;
            if (!isKnown) {
                return Optional.of("a light that is no point, ball or rectangle");
            }
            boolean isFree = light.lyingOn().isEmpty() || light.lyingOn().toleranceIfOnly(light.id, light.face) >= 0;
            if (!isFree || !light.isPoint && !light.hidesNothingOfItself) {
                return Optional.of("a light that lies on a surface");
            }
            if (light.occluders instanceof PrimitiveList some && some.size() > MOST_OCCLUDERS) {
                return Optional.of("too many objects for a list");
            }
        }
        return Optional.empty();
    }
}
