package enlightenment.world.check;

import enlightenment.frame.Bounds;
import enlightenment.math.Vec3;
import enlightenment.world.CompiledScene;
import enlightenment.world.PhysicalScene;
import enlightenment.world.light.PhysicalLight;
import enlightenment.world.material.SurfaceMaterial;

/**
 * Solids of scattering media behind a smooth refracting interface: there is no next-event estimation inside of them, and a path from the
 * eye finds a light only if it happens to leave in its direction.
 */
public final class RefractingMedia {
    /**
     * A light is small if it fills a smaller share of a hemisphere, as seen from the medium, than this: of a thousand paths that leave, one
     * hits it. Chosen, not fitted: pictures with hundreds of samples per pixel hit a larger one a few times in most pixels.
     */
    private static final double SMALL = 1e-3;

    private RefractingMedia() {}

    /**
     * Whether a scene has such solids, with any interfaces: there is no next-event estimation through several interfaces, smooth or not.
     */
    public static boolean existIn(CompiledScene scene) {
        for (int solid : scene.glassSolids) {
            SurfaceMaterial inside = scene.inside(solid);
            if (inside.medium != null && inside.indexOfRefraction != 1) {
                return true;
            }
        }
        return false;
    }

    /** Whether a scene has solids of scattering media whose interface is rough. */
    public static boolean haveRoughInterfaces(CompiledScene scene) {
        for (int id = 0; scene.physical.hasScattering && id < scene.primitives.length; id++) {
            if (hasInterface(scene, id, false)) {
                return true;
            }
        }
        return false;
    }

    /** Whether a light outside of such a solid is so small that hardly any path from inside hits it. */
    public static boolean areLitBySmallLights(CompiledScene scene) {
        for (int id = 0; scene.physical.hasScattering && id < scene.primitives.length; id++) {
            if (hasInterface(scene, id, true) && isLitBySmall(scene.physical, scene.primitives[id].bounds())) {
                return true;
            }
        }
        return false;
    }

    private static boolean hasInterface(CompiledScene scene, int id, boolean isSmooth) {
        for (int face = 0; face < scene.primitives[id].faceCount(); face++) {
            SurfaceMaterial m = scene.material(id, face);
            if (m.medium != null && m.indexOfRefraction != 1 && m.isDelta == isSmooth) {
                return true;
            }
        }
        return false;
    }

    private static boolean isLitBySmall(PhysicalScene physical, Bounds solid) {
        for (PhysicalLight light : physical.lights) {
            Vec3 center = new Vec3(light.ballX, light.ballY, light.ballZ);
            double distance =
                    solid.center().minus(center).length() - solid.extent().length() / 2;
            double radius = light.isPoint ? 0 : light.ballRadius;
            if (distance > radius && share(radius / distance) < SMALL) {
                return true;
            }
        }
        return physical.surroundings != null
                && physical.surroundings.suns.stream().anyMatch(sun -> sun.solidAngle < SMALL * 2 * Math.PI);
    }

    /** The share of a hemisphere that a ball fills, 1 − cos, given the ratio of its radius to its distance. */
    private static double share(double sine) {
        return sine * sine / (1 + Math.sqrt((1 - sine) * (1 + sine)));
    }
}
