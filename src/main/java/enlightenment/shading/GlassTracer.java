package enlightenment.shading;

import enlightenment.compiled.CompiledScene;
import enlightenment.compiled.RayCounters;
import enlightenment.geometry.Hit;
import enlightenment.geometry.Primitive;
import enlightenment.geometry.Ray;

/**
 * Follows a ray through glass: keeps the list of solids that it is inside of, bends it at true borders and lets it pass
 * where one solid merely lies inside another that outranks it.
 *
 * <p>Where two glass surfaces coincide, rounding may put the second one a hair behind the start of the ray that leaves
 * the first. {@link #settle} notices that from the list: a ray that is about to leave a solid which it never entered has
 * missed the entry, and one that is about to enter a solid which it is inside of has missed the exit.
 */
final class GlassTracer {
    private static final int MOST_COINCIDENT = 8;

    private final CompiledScene scene;
    private final RayCounters counters;
    private final MediumStack inside;
    private final Hit other = new Hit();
    private final Ray back = new Ray();

    GlassTracer(CompiledScene scene, RayCounters counters) {
        this.scene = scene;
        this.counters = counters;
        inside = new MediumStack(scene);
    }

    /** Starts a camera ray: finds out which solids it starts in. */
    void begin(Ray ray) {
        inside.clear();
        for (int id : scene.cameraSolids) {
            double x = Math.fma(ray.tMin, ray.dx, ray.ox);
            double y = Math.fma(ray.tMin, ray.dy, ray.oy);
            double z = Math.fma(ray.tMin, ray.dz, ray.oz);
            if (scene.primitives[id].contains(x, y, z)) {
                inside.add(id);
            }
        }
    }

    /** Whether the surface is no border, because a solid that outranks this one fills both of its sides. */
    boolean isHidden(int id, Hit hit) {
        if (!scene.primitives[id].isSolid()) {
            return false;
        }
        int before = inside.current();
        boolean known = inside.contains(id);
        change(id, hit.side);
        int after = inside.current();
        restore(id, known);
        return before == after;
    }

    private void change(int id, int side) {
        if (side == Ray.OUTSIDE) {
            inside.add(id);
        } else {
            inside.remove(id);
        }
    }

    private void restore(int id, boolean known) {
        if (known) {
            inside.add(id);
        } else {
            inside.remove(id);
        }
    }

    /** Passes a hidden surface. */
    void pass(Ray ray, int id, Hit hit) {
        change(id, hit.side);
        Optics.pass(ray, hit);
        settle(ray, id, hit);
    }

    /**
     * Bends the ray at a true border of glass, or reflects it totally.
     *
     * @return whether it went through
     */
    boolean refract(Ray ray, int id, Hit hit) {
        boolean through = bend(ray, id, hit);
        settle(ray, id, hit);
        return through;
    }

    private boolean bend(Ray ray, int id, Hit hit) {
        if (!scene.primitives[id].isSolid()) {
            // An open surface is a thin pane: light goes straight through it.
            counters.refractedRays++;
            Optics.pass(ray, hit);
            return true;
        }
        double from = inside.indexOfRefraction();
        boolean known = inside.contains(id);
        change(id, hit.side);
        double to = inside.indexOfRefraction();
        if (Optics.refract(ray, hit, from / to)) {
            counters.refractedRays++;
            return true;
        }
        restore(id, known);
        counters.mirrorRays++;
        Optics.reflect(ray, hit);
        return false;
    }

    /** Makes up for borders that coincide with the one just handled and that rounding put behind the ray. */
    void settle(Ray ray, int justHandled, Hit hit) {
        if (scene.glassSolids.length < 2) {
            return;
        }
        for (int k = 0; k < MOST_COINCIDENT; k++) {
            if (!settleOne(ray, justHandled, hit)) {
                return;
            }
        }
    }

    private boolean settleOne(Ray ray, int justHandled, Hit hit) {
        for (int id : scene.glassSolids) {
            Primitive p = scene.primitives[id];
            if (id == justHandled || !scene.boundsOf(id).contains(hit.point())) {
                continue;
            }
            double t = p.nearest(ray, Double.MAX_VALUE);
            int side = t == Primitive.MISS ? 0 : p.side(ray, t);
            boolean isInside = inside.contains(id);
            if (isInside ? side != Ray.INSIDE : side == Ray.INSIDE) {
                cross(ray, id, p, isInside ? Ray.INSIDE : Ray.OUTSIDE);
                return true;
            }
        }
        return false;
    }

    /** Handles a missed border at the ray's origin: its normal is found by looking back. */
    private void cross(Ray ray, int id, Primitive p, int side) {
        Primitive start = ray.start;
        int startSide = ray.startSide;
        int before = inside.current();
        double from = inside.indexOfRefraction();
        change(id, side);
        double to = inside.indexOfRefraction();
        back.set(ray.ox, ray.oy, ray.oz, -ray.dx, -ray.dy, -ray.dz, 0);
        if (before == inside.current() || !p.intersect(back, other)) {
            return;
        }
        other.side = side;
        other.setOrigin(ray);
        if (!Optics.refract(ray, other, from / to)) {
            change(id, -side);
            Optics.reflect(ray, other);
        }
        ray.from(start, startSide);
    }
}
