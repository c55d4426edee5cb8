package enlightenment.transport.ray;

import enlightenment.primitive.Hit;
import enlightenment.primitive.Primitive;
import enlightenment.primitive.Ray;
import enlightenment.world.CompiledScene;
import enlightenment.world.contact.GlassBoxes;

/** Finds interfaces of glass that coincide with the surface that a ray leaves and that rounding put behind its origin. One per thread. */
final class MissedInterfaces {
    static final int NONE = -1;

    private final CompiledScene scene;
    private final MediumStack inside;
    private final GlassBoxes.Search boxes;
    private final Ray back = new Ray();

    /**
     * @param inside the solids that the ray is inside of, without interfaces that were missed
     */
    MissedInterfaces(CompiledScene scene, MediumStack inside) {
        this.scene = scene;
        this.inside = inside;
        boxes = scene.glassBoxes.search();
    }

    /**
     * Finds an interface that the ray should have crossed but has behind it. All that coincide with it are crossed with it, so one is
     * enough.
     *
     * @param justHandled id of a solid to leave out; -1 for none
     * @param place receives the hit on the interface
     * @return the id of the solid; -1 if no interface was missed
     */
    int find(Ray ray, int justHandled, Hit place) {
        int count = boxes.around(ray.ox, ray.oy, ray.oz);
        for (int k = 0; k < count; k++) {
            int solid = boxes.solid(k);
            if (solid == justHandled) {
                continue;
            }
            Primitive p = scene.primitives[solid];
            double t = p.nearest(ray, Double.MAX_VALUE);
            int side = t == Primitive.MISS ? 0 : p.side(ray, t);
            boolean isInside = inside.contains(solid);
            if (isInside ? side != Ray.INSIDE : side == Ray.INSIDE) {
                // Its normal is found by tracing back.
                back.set(ray.ox, ray.oy, ray.oz, -ray.dx, -ray.dy, -ray.dz, 0);
                int metFrom = isInside ? Ray.INSIDE : Ray.OUTSIDE;
                if (p.intersect(back, place)) {
                    place.side = metFrom;
                    return solid;
                }
                inside.cross(solid, metFrom);
            }
        }
        return NONE;
    }
}
