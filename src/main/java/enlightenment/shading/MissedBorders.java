package enlightenment.shading;

import enlightenment.compiled.CompiledScene;
import enlightenment.primitive.Hit;
import enlightenment.primitive.Primitive;
import enlightenment.primitive.Ray;

/** Finds borders of glass that coincide with a mirror and that rounding put behind the ray, and crosses them. */
final class MissedBorders {
    /** At most this many are corrected at one point. */
    private static final int MAX_CORRECTIONS = 8;

    private final CompiledScene scene;
    private final GlassTracer glass;
    private final Hit place = new Hit();
    private final Ray back = new Ray();

    MissedBorders(CompiledScene scene, GlassTracer glass) {
        this.scene = scene;
        this.glass = glass;
    }

    void settle(Ray ray, int justHandled, Hit hit) {
        for (int k = 0; k < MAX_CORRECTIONS; k++) {
            if (!settleOne(ray, justHandled, hit)) {
                return;
            }
        }
    }

    private boolean settleOne(Ray ray, int justHandled, Hit hit) {
        for (int solid : scene.glassSolids) {
            Primitive p = scene.primitives[solid];
            if (solid == justHandled || !scene.boundsOf(solid).contains(hit.point())) {
                continue;
            }
            double t = p.nearest(ray, Double.MAX_VALUE);
            int side = t == Primitive.MISS ? 0 : p.side(ray, t);
            boolean isInside = glass.inside.contains(solid);
            if (isInside ? side != Ray.INSIDE : side == Ray.INSIDE) {
                // Its normal is found by tracing back.
                back.set(ray.ox, ray.oy, ray.oz, -ray.dx, -ray.dy, -ray.dz, 0);
                boolean found = p.intersect(back, place);
                glass.enter(ray, solid, isInside ? Ray.INSIDE : Ray.OUTSIDE, found ? place : null);
                return true;
            }
        }
        return false;
    }
}
