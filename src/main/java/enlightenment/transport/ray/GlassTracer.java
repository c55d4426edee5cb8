package enlightenment.transport.ray;

import enlightenment.bsdf.Bsdf;
import enlightenment.bsdf.Scattering;
import enlightenment.bsdf.ThinDielectric;
import enlightenment.primitive.EndFaces;
import enlightenment.primitive.Hit;
import enlightenment.primitive.Ray;
import enlightenment.transport.state.PathWavelength;
import enlightenment.world.CompiledScene;
import enlightenment.world.contact.CoincidentHits;
import enlightenment.world.parts.RayCounters;

/**
 * Follows a ray through glass: keeps the stack of solids that it is inside of, refracts it where the medium changes, and lets it pass where
 * a solid lies inside another of higher priority.
 *
 * <p>Surfaces that coincide up to rounding ({@link CoincidentHits}) are one event: first the ray leaves solids, then it enters solids, and
 * it is refracted once, from the medium before to the medium behind. An opaque surface comes between leaving and entering. So the picture
 * does not depend on the order in which rounding puts the surfaces.
 */
public final class GlassTracer {
    private static final int NONE = -1;

    private final CompiledScene scene;
    private final RayCounters counters;
    /** The solids that the ray is inside of. */
    final MediumStack inside;

    private final MediumStack saved;

    /** The media behind the interface that the last {@link #roughInterface} found. */
    private final MediumStack beyond;

    private final CoincidentHits coincident;
    private final MissedInterfaces missed;
    private final GlassInterface media;
    private final Hit nextHit = new Hit();
    /** The event that the last {@link #cross} sampled; not set if the ray passed straight. */
    public final Scattering atInterface;

    private final GlassScattering scattering;

    /** The id of the primitive whose surface the last {@link #arrive} selected. */
    int id;

    /** The id of the opaque surface that coincides with the glass surface and comes after it; -1 if there is none. */
    private int next = NONE;

    /** Whether the last {@link #cross} left the ray's direction unchanged. */
    private boolean straight;

    /** Whether the last {@link #cross} ended the path. */
    private boolean lost;

    public final PathWavelength wavelength;

    /** Whether thin slabs reflect: in physical shading. */
    private final boolean panesReflect;

    GlassTracer(CompiledScene scene, RayCounters counters) {
        panesReflect = scene.physical != null;
        this.scene = scene;
        this.counters = counters;
        wavelength = panesReflect && scene.physical.hasDispersion ? new PathWavelength() : null;
        scattering = new GlassScattering(wavelength);
        atInterface = scattering.sampled;
        inside = new MediumStack(scene, wavelength);
        saved = new MediumStack(scene, wavelength);
        beyond = new MediumStack(scene, wavelength);
        coincident = scene.coincidentHits();
        missed = new MissedInterfaces(scene, inside);
        media = new GlassInterface(coincident, inside, saved);
    }

    /**
     * Starts a ray at a point that may lie inside of some solids, and determines which. If the ray starts on the surface of one, the side
     * that it leaves on decides.
     *
     * @param solids ids of all solids that may contain the point
     * @param on the faces that the ray starts on, on their outside; null if there are none
     */
    void begin(Ray ray, int[] solids, EndFaces on) {
        next = NONE;
        inside.clear();
        for (int solid : solids) {
            int side = ray.sideOf(scene.primitives[solid]);
            if (side == Ray.INSIDE) {
                inside.add(solid);
            }
            if (side != 0 || on != null && on.hasInterfaceOf(solid)) {
                continue;
            }
            double x = Math.fma(ray.tMin, ray.dx, ray.ox);
            double y = Math.fma(ray.tMin, ray.dy, ray.oy);
            double z = Math.fma(ray.tMin, ray.dz, ray.oz);
            if (scene.primitives[solid].contains(x, y, z)) {
                inside.add(solid);
            }
        }
        if (on != null && on.hasInterfaces()) {
            settle(ray, NONE);
        }
    }

    /** Whether the last {@link #arrive} found a single opaque surface, seen from empty space. */
    public boolean isPlain() {
        int found = coincident.size();
        return inside.size() == 0 && (found == 0 || found == 1 && !coincident.isGlass(0));
    }

    /** Starts a ray behind a hole of a surface (an alpha mask): on that surface alone. */
    void startBehindHole(Ray ray) {
        coincident.startBehind(ray, false);
        coincident.clear();
        next = NONE;
    }

    /** Clears the coincident surfaces, for a ray that continues from a point on no surface. */
    void leaveSurfaces() {
        coincident.clear();
        next = NONE;
    }

    /** Starts a ray in the medium of another path; if isBeyond, in that behind the rough interface that the path is at. */
    void begin(GlassTracer other, boolean isBeyond) {
        next = isBeyond ? other.next : other.coincident.left(nextHit);
        if (isBeyond && next != NONE) {
            nextHit.set(other.nextHit);
        }
        inside.set(isBeyond ? other.beyond : other.inside);
        if (wavelength != null) {
            wavelength.set(other.wavelength);
        }
    }

    /** Starts a ray in the medium of another path, at a point of its flight before the surface that it has hit since. */
    void beginOnTheWay(GlassTracer other) {
        next = NONE;
        inside.set(other.inside);
        if (wavelength != null) {
            wavelength.set(other.wavelength);
        }
    }

    /** Returns and clears the opaque surface at the point where the ray has just left glass; -1 if the ray must be traced. */
    int takeNext(Hit hit) {
        int taken = next;
        next = NONE;
        if (taken != NONE) {
            hit.set(nextHit);
        }
        return taken;
    }

    /**
     * Examines a hit together with the surfaces that coincide with it.
     *
     * @param struck id of the primitive that was hit
     * @param hit is replaced by the hit on the surface of the event, whose primitive is {@link #id}: the visible opaque surface, or one by
     *     which the ray leaves glass
     * @return whether the event is at glass
     */
    boolean arrive(Ray ray, int struck, Hit hit) {
        id = struck;
        boolean glass = scene.isGlass(struck, hit.face);
        if (!glass && inside.size() == 0 && !scene.coincident.concerns(struck)) {
            coincident.clear();
            return false;
        }
        coincident.find(ray, struck, hit);
        if (!glass && inside.size() == 0 && coincident.size() == 1) {
            return false;
        }
        int opaque = coincident.seen();
        if (opaque == NONE) {
            next = NONE;
            return true;
        }
        int leaving = leaving();
        if (leaving != NONE) {
            next = coincident.id(opaque);
            nextHit.set(coincident.hit(opaque));
            id = coincident.id(leaving);
            hit.set(coincident.hit(leaving));
            return true;
        }
        id = coincident.id(opaque);
        if (opaque > 0) {
            hit.set(coincident.hit(opaque));
        }
        return false;
    }

    /** The index of the first coincident surface by which the ray leaves a solid that it is inside of; -1 if there is none. */
    private int leaving() {
        for (int k = 0; k < coincident.size(); k++) {
            if (coincident.isGlass(k) && coincident.hit(k).side == Ray.INSIDE && inside.contains(coincident.id(k))) {
                return k;
            }
        }
        return NONE;
    }

    /**
     * Passes, refracts or reflects the ray at the surfaces that the last {@link #arrive} found.
     *
     * @return whether it was transmitted
     */
    boolean cross(Ray ray, Hit hit) {
        double from = inside.leave();
        media.cross(next != NONE);
        double to = inside.enter();
        straight = !media.changesMedium() || from == to;
        lost = false;
        if (straight && panesReflect && isReflectedByPane(ray, hit)) {
            straight = false;
            reflect(ray);
            return false;
        }
        if (straight) {
            Optics.pass(ray, hit);
            coincident.startBehind(ray, next != NONE);
            return true;
        }
        lost = !scattering.atInterface(ray, hit, media.bsdf(), media.hit(), from / to);
        if (atInterface.transmitted) {
            counters.refractedRays++;
            coincident.startBehind(ray, next != NONE);
            return true;
        }
        reflect(ray);
        return false;
    }

    /** Restores the media for a reflected ray; it returns to the coincident opaque surface if it has just left one. */
    private void reflect(Ray ray) {
        media.undo();
        next = coincident.left(nextHit);
        counters.mirrorRays++;
        coincident.startOn(ray);
    }

    /**
     * Lets a shadow ray pass the surfaces of glass that {@link #arrive} found, if they do not change its direction.
     *
     * @return the Fresnel transmittance of thin slabs, without colours and transparency of materials; 0 if the surfaces change the
     *     direction
     */
    double passStraight(Ray ray, Hit hit) {
        double from = inside.indexOfRefraction();
        media.cross(next != NONE);
        straight = !media.changesMedium() || from == inside.indexOfRefraction();
        if (!straight) {
            return 0;
        }
        int pane = coincident.pane();
        double share = 1;
        if (pane != NONE) {
            double cosine = (ray.dx * hit.nx + ray.dy * hit.ny + ray.dz * hit.nz) / Math.sqrt(ray.dd);
            share = ThinDielectric.transmittance(cosine, inside.over(coincident.material(pane)));
        }
        Optics.pass(ray, hit);
        coincident.startBehind(ray, next != NONE);
        return share;
    }

    private boolean isReflectedByPane(Ray ray, Hit hit) {
        int k = coincident.pane();
        return k != NONE && scattering.isReflectedByPane(ray, hit, inside.over(coincident.material(k)));
    }

    /**
     * Samples which of the surfaces that {@link #arrive} found is opaque, where some are partly transparent; the ray does not cross them.
     *
     * @param number uniform in [0, 1)
     * @return the index of the coincident surface; -1 if the ray passes all of them
     */
    public int opaque(double number) {
        media.cross(next != NONE);
        media.undo();
        int opaque = media.opaque(number);
        next = opaque == NONE ? next : NONE;
        return opaque;
    }

    /** Multiplies a share of light by the transparency of the surfaces that it crosses: the probability that {@link #opaque} returns -1. */
    public double clear(double share) {
        return media.clear(share);
    }

    /** The scattering function of the surfaces that {@link #arrive} found if they are a rough interface, with s set; else null. */
    Bsdf roughInterface(Ray ray, Hit hit, Scattering s) {
        double from = inside.leave();
        media.cross(next != NONE);
        double to = inside.enter();
        beyond.set(inside);
        media.undo();
        if (!media.changesMedium() || from == to) {
            return null;
        }
        Bsdf bsdf = media.bsdf();
        Optics.arrive(s, ray, hit);
        s.eta = from / to;
        return bsdf.isDelta() ? null : bsdf;
    }

    /** The throughput weight of the last {@link #cross}, before colours: the value of the lobe over the density; 0 if the path ends. */
    public double weight() {
        return straight ? 1 : lost ? 0 : atInterface.valueR;
    }

    /** The probability of the choice of reflection or transmission in the last {@link #cross}. */
    public double probability() {
        return straight && !(panesReflect && coincident.pane() != NONE) ? 1 : atInterface.pdf;
    }

    /** Sets the random numbers of the next {@link #cross}: one selects reflection or refraction, the pair a direction. */
    public void choose(double number, double[] pair) {
        scattering.choose(number, pair);
    }

    /** The index of refraction of the medium that the ray is in. */
    public double indexOfRefraction() {
        return inside.indexOfRefraction();
    }

    /** The id of the solid that is the current medium or, if isBeyond, that behind the rough interface; -1 in empty space. */
    int medium(boolean isBeyond) {
        return (isBeyond ? beyond : inside).current();
    }

    /** Whether the last {@link #cross} kept the direction: by a thin slab, media of equal index, or no change of medium. */
    public boolean passedStraight() {
        return straight;
    }

    /** Starts a ray that leaves a rough interface on all surfaces that coincide there. */
    void startAtInterface(Ray ray, boolean through) {
        if (through) {
            coincident.startBehind(ray, next != NONE);
        } else {
            coincident.startOn(ray);
        }
    }

    /** Starts a ray that stays on the side it came from on all surfaces that {@link #arrive} found. */
    public void startOnAll(Ray ray) {
        coincident.startOn(ray);
    }

    /** The number of coincident surfaces. */
    public int surfaces() {
        return coincident.size();
    }

    /** Whether coincident surface k filters the light: the interface does, and thin slabs that transmitted the ray. */
    public boolean filters(int k, boolean through) {
        return media.filters(k, through);
    }

    /** The id of the primitive that coincident surface k belongs to. */
    public int surface(int k) {
        return coincident.id(k);
    }

    /** The hit on coincident surface k. */
    public Hit hitOf(int k) {
        return coincident.hit(k);
    }

    /**
     * Finds an interface that coincides with the opaque surface or light that a ray leaves, but that rounding put behind the origin: the
     * ray meets it next.
     */
    void settle(Ray ray, int justHandled) {
        next = missed.find(ray, justHandled, nextHit);
    }

    /** Whether a ray that leaves the opaque surface there is at once in the glass that the path has just left. */
    public boolean entersAtOnce() {
        return coincident.hasLeftGlass();
    }

    /** Whether a ray that leaves an interface on one side meets a coincident opaque surface at once. */
    public boolean comesToOpaque(boolean through) {
        return through ? hasNext() : coincident.hasLeftOpaque();
    }

    /** Whether a coincident opaque surface is the next vertex after the interface that the path crossed or was reflected by. */
    public boolean hasNext() {
        return next != NONE;
    }
}
