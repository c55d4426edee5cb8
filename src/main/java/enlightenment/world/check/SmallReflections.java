package enlightenment.world.check;

import enlightenment.frame.Bounds;
import enlightenment.math.Vec3;
import enlightenment.primitive.Primitive;
import enlightenment.world.CompiledScene;
import enlightenment.world.camera.EyeProjection;
import enlightenment.world.light.PhysicalLight;
import enlightenment.world.light.SpecularCasters;
import enlightenment.world.material.SurfaceMaterial;

/**
 * Lamps whose reflections in curved mirrors or glass may be smaller than a pixel, so that the samples of a pixel may all miss them. A
 * sphere maps directions of reflection uniformly to the area of its disk in the picture, so that the reflection of a lamp of solid angle Ω
 * fills the share Ω / 4π of that.
 */
public final class SmallReflections {
    /** The largest number of pairs of object and lamp that are examined. */
    private static final int MOST_PAIRS = 1 << 20;

    private SmallReflections() {}

    /** Whether a scene of physical shading may show such a reflection. */
    public static boolean mayBeThere(CompiledScene scene) {
        EyeProjection eye = EyeProjection.of(scene.camera);
        int pairs = 0;
        for (int id = 0; id < scene.primitives.length && pairs < MOST_PAIRS; id++) {
            if (!isCurvedAndSharp(scene, id)) {
                continue;
            }
            Bounds box = scene.primitives[id].bounds();
            double pixels = pixels(scene, eye, box);
            for (PhysicalLight light : scene.physical.lights) {
                pairs++;
                if (!light.isPoint && pixels > 0 && pixels * share(light, box) < 1) {
                    return true;
                }
            }
        }
        return false;
    }

    private static boolean isCurvedAndSharp(CompiledScene scene, int id) {
        Primitive p = scene.primitives[id];
        for (int face = 0; face < p.faceCount(); face++) {
            SurfaceMaterial material = scene.material(id, face);
            boolean isCurved = !p.support(face).isFlat() || material.turnsNormals();
            if (isCurved && material.any(SpecularCasters::isSharp)) {
                return true;
            }
        }
        return false;
    }

    /** The area of the object's box in the picture, in pixels; of one that reaches behind the eye, that of the picture. */
    private static double pixels(CompiledScene scene, EyeProjection eye, Bounds box) {
        double left = 1;
        double right = 0;
        double top = 1;
        double bottom = 0;
        for (int k = 0; k < 8; k++) {
            Vec3 corner = box.corner(k);
            if (!eye.place(corner.x(), corner.y(), corner.z())) {
                return scene.camera.columns * (double) scene.camera.rows;
            }
            left = Math.min(left, eye.x);
            right = Math.max(right, eye.x);
            top = Math.min(top, eye.y);
            bottom = Math.max(bottom, eye.y);
        }
        boolean isSeen = left < 1 && right > 0 && top < 1 && bottom > 0;
        return isSeen ? (right - left) * scene.camera.columns * (bottom - top) * scene.camera.rows : 0;
    }

    /** The share of the sphere of directions that the lamp fills as seen from the object. */
    private static double share(PhysicalLight light, Bounds from) {
        Vec3 way = from.center().minus(new Vec3(light.ballX, light.ballY, light.ballZ));
        double square = way.dot(way);
        return Math.min(light.ballRadius * light.ballRadius / (4 * square), 1);
    }
}
