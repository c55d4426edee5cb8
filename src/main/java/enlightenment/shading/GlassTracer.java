package enlightenment.shading;

import enlightenment.compiled.CoincidentHits;
import enlightenment.compiled.CompiledScene;
import enlightenment.compiled.RayCounters;
import enlightenment.primitive.Hit;
import enlightenment.primitive.Primitive;
import enlightenment.primitive.Ray;

/**
 * Follows a ray through glass: keeps the list of solids that it is inside of, bends it at true borders and lets it pass
 * where one solid merely lies inside another that outranks it.
 *
 * <p>Surfaces that coincide up to rounding ({@link CoincidentHits}) are one event: first everything that is left is left, then
 * everything that is entered is entered, and the ray is bent once, from the medium before to the medium after. What is
 * opaque comes between leaving and entering. So the picture does not depend on which of the surfaces rounding puts first.
 */
final class GlassTracer {
    private static final int MOST_COINCIDENT = 8;
    private static final int NONE = -1;

    private final CompiledScene scene;
    private final RayCounters counters;
    private final MediumStack inside;
    private final MediumStack saved;
    private final CoincidentHits contacts;
    private final Hit other = new Hit();
    private final Hit nextHit = new Hit();
    private final Ray back = new Ray();

    /** The surface that {@link #arrive} chose among those that coincide, where it is no event of glass. */
    int id;

    /** The opaque surface that lies behind the glass surface in the same place, or -1. */
    private int next = NONE;

    /** Whether the last {@link #cross} left the ray's direction as it was. */
    private boolean straight;

    /** Index of the contact whose surface is the border of the two media, or -1. */
    private int border;

    GlassTracer(CompiledScene scene, RayCounters counters) {
        this.scene = scene;
        this.counters = counters;
        inside = new MediumStack(scene);
        saved = new MediumStack(scene);
        contacts = new CoincidentHits(scene);
    }

    /** Starts a camera ray: finds out which solids it starts in. */
    void begin(Ray ray) {
        next = NONE;
        inside.clear();
        for (int solid : scene.cameraSolids) {
            double x = Math.fma(ray.tMin, ray.dx, ray.ox);
            double y = Math.fma(ray.tMin, ray.dy, ray.oy);
            double z = Math.fma(ray.tMin, ray.dz, ray.oz);
            if (scene.primitives[solid].contains(x, y, z)) {
                inside.add(solid);
            }
        }
    }

    /** The opaque surface that the ray meets where it just left glass, or -1 if it must be traced. */
    int takeNext(Hit hit) {
        int taken = next;
        next = NONE;
        if (taken != NONE) {
            hit.set(nextHit);
        }
        return taken;
    }

    /**
     * Looks at what a ray has hit, together with what coincides with it.
     *
     * @param hit becomes that of the opaque surface, if that is what counts
     * @return whether it is an event of glass; otherwise the surface {@link #id} is opaque
     */
    boolean arrive(Ray ray, int struck, Hit hit) {
        id = struck;
        boolean glass = isGlass(struck, hit);
        if (!glass && inside.size() == 0 && !scene.coincident.concerns(struck)) {
            contacts.clear();
            return false;
        }
        contacts.find(ray, struck, hit);
        int opaque = contacts.seen(true);
        boolean leaving = false;
        for (int k = 0; k < contacts.size(); k++) {
            int c = contacts.id(k);
            Hit h = contacts.hit(k);
            leaving |= isGlass(c, h) && h.side == Ray.INSIDE && inside.contains(c);
        }
        if (opaque == NONE || leaving) {
            next = opaque == NONE ? NONE : contacts.id(opaque);
            if (next != NONE) {
                nextHit.set(contacts.hit(opaque));
            }
            return true;
        }
        id = contacts.id(opaque);
        if (opaque > 0) {
            hit.set(contacts.hit(opaque));
        }
        return false;
    }

    private boolean isGlass(int candidate, Hit hit) {
        return scene.isGlass(candidate, hit.face);
    }

    /**
     * Passes, bends or reflects the ray at the surfaces that {@link #arrive} found.
     *
     * @return whether it went through
     */
    boolean cross(Ray ray, Hit hit) {
        int before = inside.current();
        double from = inside.indexOfRefraction();
        saved.set(inside);
        for (int k = 0; k < contacts.size(); k++) {
            if (isGlassSolid(k)) {
                change(contacts.id(k), contacts.hit(k).side);
            }
        }
        int after = inside.current();
        border = before == after ? NONE : borderOf(before, after);
        double to = inside.indexOfRefraction();
        straight = border == NONE || from == to;
        if (straight) {
            Optics.pass(ray, hit);
            startOnAll(ray, -1);
            return true;
        }
        if (Optics.refract(ray, hit, from / to)) {
            counters.refractedRays++;
            startOnAll(ray, -1);
            return true;
        }
        inside.set(saved);
        next = NONE;
        counters.mirrorRays++;
        Optics.reflect(ray, hit);
        startOnAll(ray, 1);
        return false;
    }

    /** Whether the last {@link #cross} did not turn the ray: through a pane, or between media of one index. */
    boolean passedStraight() {
        return straight;
    }

    private boolean isGlassSolid(int k) {
        return scene.primitives[contacts.id(k)].isSolid() && isGlass(contacts.id(k), contacts.hit(k));
    }

    private void change(int solid, int side) {
        if (side == Ray.OUTSIDE) {
            inside.add(solid);
        } else {
            inside.remove(solid);
        }
    }

    /** The surface of the medium that is entered; where only something is left, of that. */
    private int borderOf(int before, int after) {
        int found = 0;
        for (int k = 0; k < contacts.size(); k++) {
            if (contacts.id(k) == after) {
                return k;
            }
            found = contacts.id(k) == before ? k : found;
        }
        return found;
    }

    /** Says that the ray starts on all coinciding surfaces of glass, and where it stays, on opaque ones. */
    private void startOnAll(Ray ray, int sign) {
        for (int k = 1; k < contacts.size(); k++) {
            if (sign > 0 || isGlass(contacts.id(k), contacts.hit(k))) {
                ray.alsoFrom(scene.primitives[contacts.id(k)], sign * contacts.hit(k).side);
            }
        }
    }

    /**
     * Says that a ray that leaves one of the surfaces that {@link #arrive} found, on the side where it came from, leaves all of
     * them.
     */
    void startOnAll(Ray ray) {
        startOnAll(ray, true);
    }

    /** The same for a ray that is reflected, but for borders of glass solids: these it must cross again. */
    void reflectFromAll(Ray ray) {
        startOnAll(ray, false);
    }

    private void startOnAll(Ray ray, boolean glassSolids) {
        for (int k = 0; k < contacts.size(); k++) {
            Primitive p = scene.primitives[contacts.id(k)];
            if (p != ray.start && (glassSolids || !isGlassSolid(k))) {
                ray.alsoFrom(p, contacts.hit(k).side);
            }
        }
    }

    /** How many coinciding surfaces there are. */
    int surfaces() {
        return contacts.size();
    }

    /** Whether the light took the colour of surface k: that of the border, and those of panes that it went through. */
    boolean filters(int k, boolean through) {
        return k == border || through && !isGlassSolid(k) && isGlass(contacts.id(k), contacts.hit(k));
    }

    int surface(int k) {
        return contacts.id(k);
    }

    Hit hitOf(int k) {
        return contacts.hit(k);
    }

    /** Makes up for borders that coincide with a mirror and that rounding put behind the ray. */
    void settle(Ray ray, int justHandled, Hit hit) {
        for (int k = 0; k < MOST_COINCIDENT; k++) {
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
            boolean isInside = inside.contains(solid);
            if (isInside ? side != Ray.INSIDE : side == Ray.INSIDE) {
                enter(ray, solid, p, isInside ? Ray.INSIDE : Ray.OUTSIDE);
                return true;
            }
        }
        return false;
    }

    /** Handles a missed border at the ray's origin: its normal is found by looking back. */
    private void enter(Ray ray, int solid, Primitive p, int side) {
        Primitive start = ray.start;
        int startSide = ray.startSide;
        int before = inside.current();
        double from = inside.indexOfRefraction();
        change(solid, side);
        double to = inside.indexOfRefraction();
        back.set(ray.ox, ray.oy, ray.oz, -ray.dx, -ray.dy, -ray.dz, 0);
        if (before == inside.current() || !p.intersect(back, other)) {
            return;
        }
        other.side = side;
        other.setOrigin(ray);
        if (!Optics.refract(ray, other, from / to)) {
            change(solid, -side);
            Optics.reflect(ray, other);
        }
        ray.from(start, startSide);
    }
}
