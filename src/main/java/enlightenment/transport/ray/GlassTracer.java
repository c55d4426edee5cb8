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
 * Follows a ray through glass: keeps track of the solids that it is inside of, refracts it where the medium changes and lets it
 * pass where a solid lies inside another of higher priority.
 *
 * <p>Surfaces that coincide up to rounding ({@link CoincidentHits}) are one event: first the ray leaves solids, then it enters
 * solids, and it is refracted once, from the medium before to the medium after. An opaque surface comes between leaving and
 * entering. So the picture does not depend on which of the surfaces rounding puts first.
 */
public final class GlassTracer {
    private static final int NONE = -1;

    private final CompiledScene scene;
    private final RayCounters counters;
    /** The solids that the ray is inside of. */
    final MediumStack inside;

    private final MediumStack saved;

    /** The media behind the border that {@link #roughBorder} found. */
    private final MediumStack beyond;

    private final CoincidentHits coincident;
    private final MissedBorders missed;
    private final GlassBorder media;
    private final Hit nextHit = new Hit();
    /** What the last {@link #cross} sampled, unless it passed straight. */
    public final Scattering border;

    private final GlassScattering scattering;

    /** The primitive of the surface that {@link #arrive} chose among those that coincide. */
    int id;

    /** The opaque surface that coincides with the glass surface and comes after it, or -1. */
    private int next = NONE;

    /** Whether the last {@link #cross} left the ray's direction unchanged. */
    private boolean straight;

    /** Whether the last {@link #cross} ended the path. */
    private boolean lost;

    public final PathWavelength wavelength;

    /** Whether panes reflect: in physical shading. */
    private final boolean panesReflect;

    GlassTracer(CompiledScene scene, RayCounters counters) {
        panesReflect = scene.physical != null;
        this.scene = scene;
        this.counters = counters;
        wavelength = panesReflect && scene.physical.hasDispersion ? new PathWavelength() : null;
        scattering = new GlassScattering(wavelength);
        border = scattering.sampled;
        inside = new MediumStack(scene, wavelength);
        saved = new MediumStack(scene, wavelength);
        beyond = new MediumStack(scene, wavelength);
        coincident = scene.coincidentHits();
        missed = new MissedBorders(scene, inside);
        media = new GlassBorder(coincident, inside, saved);
    }

    /**
     * Starts a ray that may start in some solids, and finds in which. If it starts on one of them, the side that it leaves that on decides.
     *
     * @param on the faces that it starts on, which it is outside of; null if there are none
     */
    void begin(Ray ray, int[] solids, EndFaces on) {
        next = NONE;
        inside.clear();
        for (int solid : solids) {
            int side = ray.sideOf(scene.primitives[solid]);
            if (side == Ray.INSIDE) {
                inside.add(solid);
            }
            if (side != 0 || on != null && on.hasBorderOf(solid)) {
                continue;
            }
            double x = Math.fma(ray.tMin, ray.dx, ray.ox);
            double y = Math.fma(ray.tMin, ray.dy, ray.oy);
            double z = Math.fma(ray.tMin, ray.dz, ray.oz);
            if (scene.primitives[solid].contains(x, y, z)) {
                inside.add(solid);
            }
        }
        if (on != null && on.hasBorders()) {
            settle(ray, NONE);
        }
    }

    /** Whether the last {@link #arrive} found nothing but one opaque surface, from empty space. */
    public boolean isPlain() {
        int found = coincident.size();
        return inside.size() == 0 && (found == 0 || found == 1 && !coincident.isGlass(0));
    }

    /** Lets a ray that passes a hole start behind it: on nothing but the surface that the hole is in. */
    void startBehindHole(Ray ray) {
        coincident.startBehind(ray, false);
        coincident.clear();
        next = NONE;
    }

    /** The ray is at no surface now. */
    void leaveSurfaces() {
        coincident.clear();
        next = NONE;
    }

    /** Starts a ray in the medium that another one is in, or behind the rough border that that came to. */
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

    /** Starts a ray in the medium that another one is flying through, whatever that has come to. */
    void beginOnTheWay(GlassTracer other) {
        next = NONE;
        inside.set(other.inside);
        if (wavelength != null) {
            wavelength.set(other.wavelength);
        }
    }

    /** The opaque surface that the ray meets at the point where it just left glass, or -1 if the ray must be traced. */
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
     * @param hit is replaced by that of the surface that the event is at, whose primitive is {@link #id} then: the opaque one that is seen, or
     *     one by which the ray leaves glass
     * @return whether the event is one of glass
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

    /** The first of the surfaces at which the ray leaves a solid that it is inside of, or -1. */
    private int leaving() {
        for (int k = 0; k < coincident.size(); k++) {
            if (coincident.isGlass(k) && coincident.hit(k).side == Ray.INSIDE && inside.contains(coincident.id(k))) {
                return k;
            }
        }
        return NONE;
    }

    /**
     * Passes, refracts or reflects the ray at the surfaces that {@link #arrive} found.
     *
     * @return whether it was transmitted
     */
    boolean cross(Ray ray, Hit hit) {
        double from = inside.leave();
        media.cross(next != NONE);
        double to = inside.enter();
        straight = !media.isThere() || from == to;
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
        lost = !scattering.atBorder(ray, hit, media.bsdf(), media.hit(), from / to);
        if (border.transmitted) {
            counters.refractedRays++;
            coincident.startBehind(ray, next != NONE);
            return true;
        }
        reflect(ray);
        return false;
    }

    /** Undoes the crossing of borders: the ray stays on its side, and comes back to what is opaque there if it has just left that. */
    private void reflect(Ray ray) {
        media.undo();
        next = coincident.left(nextHit);
        counters.mirrorRays++;
        coincident.startOn(ray);
    }

    /**
     * Lets a shadow ray pass the surfaces of glass that {@link #arrive} found, if they do not turn it.
     *
     * @return the share of the light that passes where nothing is opaque and colours are white; 0 if the surfaces turn the ray
     */
    double passStraight(Ray ray, Hit hit) {
        double from = inside.indexOfRefraction();
        media.cross(next != NONE);
        straight = !media.isThere() || from == inside.indexOfRefraction();
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
     * Which of the surfaces of glass that {@link #arrive} found is opaque, where some are so in part: the ray does not cross it.
     *
     * @param number 0..1, chooses
     * @return the index of the coincident surface, or -1 if all are clear
     */
    public int opaque(double number) {
        media.cross(next != NONE);
        media.undo();
        int opaque = media.opaque(number);
        next = opaque == NONE ? next : NONE;
        return opaque;
    }

    /**
     * What is left of a share of light that crosses the surfaces where some are opaque in part: {@link #opaque} finds all of them clear with
     * this probability.
     */
    public double clear(double share) {
        return media.clear(share);
    }

    /**
     * How the surfaces that {@link #arrive} found scatter light as a rough border of two media, and where; null if they are none.
     */
    Bsdf roughBorder(Ray ray, Hit hit, Scattering s) {
        double from = inside.leave();
        media.cross(next != NONE);
        double to = inside.enter();
        beyond.set(inside);
        media.undo();
        if (!media.isThere() || from == to) {
            return null;
        }
        Bsdf bsdf = media.bsdf();
        Optics.arrive(s, ray, hit);
        s.eta = from / to;
        return bsdf.isDelta() ? null : bsdf;
    }

    /** What the value of the border's lobe is, over the probability of the direction. */
    public double weight() {
        return straight ? 1 : lost ? 0 : border.valueR;
    }

    /** The probability of what the last {@link #cross} has chosen between reflection and transmission. */
    public double probability() {
        return straight && !(panesReflect && coincident.pane() != NONE) ? 1 : border.pdf;
    }

    /** Sets the number that chooses between reflection and refraction next. */
    public void choose(double number, double[] pair) {
        scattering.choose(number, pair);
    }

    /** The index of refraction of the medium that the ray is in. */
    public double indexOfRefraction() {
        return inside.indexOfRefraction();
    }

    /** The solid that is the medium that the ray is in, or that behind a rough border; -1 in empty space. */
    int medium(boolean isBeyond) {
        return (isBeyond ? beyond : inside).current();
    }

    /** Whether the last {@link #cross} did not turn the ray: it passed a pane, between media of equal index, or what is no border. */
    public boolean passedStraight() {
        return straight;
    }

    /** Starts a ray that leaves a rough border on all surfaces there. */
    void startAtBorder(Ray ray, boolean through) {
        if (through) {
            coincident.startBehind(ray, next != NONE);
        } else {
            coincident.startOn(ray);
        }
    }

    /** Starts a ray that leaves one of the surfaces that {@link #arrive} found, on the side it came from, on all of them. */
    public void startOnAll(Ray ray) {
        coincident.startOn(ray);
    }

    /** The number of coincident surfaces. */
    public int surfaces() {
        return coincident.size();
    }

    /** Whether surface k filters the light: the boundary does, and so do panes that the ray passed. */
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
     * Finds a border that coincides with the opaque surface or the light that a ray leaves, and that rounding put behind it: the ray comes
     * to that border next.
     */
    void settle(Ray ray, int justHandled) {
        next = missed.find(ray, justHandled, nextHit);
    }

    /** Whether a ray that leaves the opaque surface there enters glass at once, which the path left there. */
    public boolean entersAtOnce() {
        return coincident.hasLeftGlass();
    }

    /** Whether a ray that leaves a border to one side comes at once to an opaque surface there. */
    public boolean comesToOpaque(boolean through) {
        return through ? hasNext() : coincident.hasLeftOpaque();
    }

    /** Whether an opaque surface is where a path goes on from the border that it crossed, or that reflected it. */
    public boolean hasNext() {
        return next != NONE;
    }
}
