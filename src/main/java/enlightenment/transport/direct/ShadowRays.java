package enlightenment.transport.direct;

import enlightenment.emitter.LightSample;
import enlightenment.primitive.Hit;
import enlightenment.primitive.Primitive;
import enlightenment.primitive.Ray;
import enlightenment.transport.ray.Departure;
import enlightenment.transport.ray.GlassTracer;
import enlightenment.transport.ray.PathFollower;
import enlightenment.transport.ray.ShadowWalk;
import enlightenment.transport.state.GatheredLight;
import enlightenment.world.CompiledScene;
import enlightenment.world.Tracer;
import enlightenment.world.light.LightCone;
import enlightenment.world.light.PhysicalLight;
import enlightenment.world.material.SurfaceMaterial;
import enlightenment.world.parts.RayCounters;
import java.util.Arrays;

/** Visibility of lights from a vertex of a path, and the transmittance of the medium and of glass that keeps directions on the way. */
public final class ShadowRays {
    private final PathFollower path;
    private final Hit hit;
    private final GlassTracer glass;
    private final Tracer tracer;
    private final LightCone cone;
    private final Ray ray = new Ray();
    private final RayCounters counters;
    private final boolean absorbs;
    private final double[] relative = new double[3];
    private final Hit textured = new Hit();

    /** Follows shadow rays through glass that keeps their direction; null if the scene has none. */
    private final ShadowWalk walk;

    /**
     * The ids of primitives that the vertex lies on, which shadow rays skip; beyond eight the others are tested needlessly. The last place
     * is for the light's own.
     */
    private final int[] starts = new int[9];

    private int startCount;

    private double x;
    private double y;
    private double z;

    /** The absorbing medium that the vertex lies in; null if that is none. */
    private SurfaceMaterial medium;

    /** Whether the vertex is on a rough interface, and whether shadow rays leave on its far side, as the path came. */
    private boolean isInterface;

    private boolean isBeyond;

    /** Whether the vertex is a point of a flight before the surface that the path has hit since. */
    private boolean isOnTheWay;

    /** The side of the surface that shadow rays leave on. */
    private int side;

    /** Whether a single primitive occludes the whole light. */
    private boolean isHidden;

    /** Whether {@link #rgb} applies to the last shadow ray that was not blocked; if not, the transmittance is 1. */
    public boolean isFiltered;

    /**
     * The transmittance by band; of a point light with a profile times the relative intensity in this direction, of a textured light times
     * the factor of its point.
     */
    public final double[] rgb = new double[3];

    /**
     * @param cone around the light in question, with its apex at the vertex
     */
    public ShadowRays(CompiledScene scene, RayCounters counters, PathFollower path, LightCone cone) {
        this.path = path;
        this.cone = cone;
        this.counters = counters;
        hit = path.at.hit;
        glass = path.glass;
        tracer = path.tracer;
        absorbs = scene.physical.hasAbsorption;
        walk = scene.physical.hasStraightGlass ? new ShadowWalk(scene, counters) : null;
    }

    /** Begins at the path's current surface, on the side that the path came from. */
    public void begin() {
        isInterface = false;
        turn(false);
    }

    /** Begins on one side of the rough interface that the path is at. */
    public void beginAtInterface(boolean through) {
        isInterface = true;
        turn(through);
    }

    /** Begins at a point of a flight through a medium, before the surface that the path has hit since. */
    void beginOnTheWay(double px, double py, double pz) {
        isInterface = false;
        isOnTheWay = true;
        startCount = 0;
        place(px, py, pz, false);
    }

    private void turn(boolean through) {
        isOnTheWay = false;
        side = through ? -hit.side : hit.side;
        place(hit.px, hit.py, hit.pz, through);
        findStarts();
    }

    private void place(double px, double py, double pz, boolean through) {
        x = px;
        y = py;
        z = pz;
        isBeyond = through;
        medium = absorbs ? path.medium(through) : null;
        if (medium != null && !medium.absorbs) {
            medium = null;
        }
    }

    private void findStarts() {
        int count = 0;
        if (neverReturnsTo(hit, side)) {
            starts[count++] = path.at.id;
        }
        for (int k = 0; k < glass.surfaces() && count < starts.length - 1; k++) {
            Hit h = glass.hitOf(k);
            if (glass.surface(k) != path.at.id && neverReturnsTo(h, isBeyond ? -h.side : h.side)) {
                starts[count++] = glass.surface(k);
            }
        }
        startCount = count;
    }

    /** Whether a ray that leaves the surface on this side cannot hit it again; false if the hit is on no surface. */
    private static boolean neverReturnsTo(Hit place, int side) {
        Primitive p = place.primitive;
        return p != null && (p.isFlat() || p.isConvex() && side == Ray.OUTSIDE);
    }

    /** The visibility of the whole light as far as it is known without a ray. Must precede {@link #isBlocked}. */
    public Tracer.Visibility visibility(PhysicalLight l) {
        if (!isOnTheWay && Departure.isStopped(path, isInterface, isBeyond)) {
            isHidden = true;
            return walk == null ? Tracer.Visibility.NONE : Tracer.Visibility.UNKNOWN;
        }
        int count = startCount;
        if (l.hidesNothingOfItself) {
            starts[count++] = l.id;
        }
        Tracer.Visibility known = tracer.prepareShadows(cone, starts, count, 1);
        // Absorption depends on the length of the ray, so that closed forms do not apply; and an occluder may be glass
        // that transmits
        // light. Each ray tests whether another light covers this one.
        isHidden = known == Tracer.Visibility.NONE;
        boolean isOpen =
                known == Tracer.Visibility.ALL ? medium != null || l.lyingOn().hasCovers() : walk != null;
        return isOpen ? Tracer.Visibility.UNKNOWN : known;
    }

    /**
     * Whether nothing occludes a sampled point of the light. {@link #rgb} then has the transmittance, times the factors of profile and
     * texture.
     */
    public boolean isVisible(PhysicalLight l, LightSample to) {
        if (l.profile != null && !(l.profile.luminance(-to.dx, -to.dy, -to.dz) > 0)) {
            counters.lightSamplesWithoutRay++;
            return false;
        }
        Tracer.Visibility known = visibility(l);
        if (known != Tracer.Visibility.UNKNOWN) {
            counters.lightSamplesWithoutRay++;
        }
        boolean isSeen = known == Tracer.Visibility.UNKNOWN ? !isBlocked(l, to) : known == Tracer.Visibility.ALL;
        if (isSeen && l.profile != null) {
            weighByProfile(l, to);
        }
        if (isSeen && l.texture != null) {
            weighByTexture(l, to);
        }
        return isSeen;
    }

    private void weighByProfile(PhysicalLight l, LightSample to) {
        l.profile.intensity(-to.dx, -to.dy, -to.dz, relative);
        weigh();
    }

    /** Multiplies {@link #rgb} by the factor of a textured light's point. */
    void weighByTexture(PhysicalLight l, LightSample to) {
        l.texture.factor(
                Math.fma(to.length, to.dx, x),
                Math.fma(to.length, to.dy, y),
                Math.fma(to.length, to.dz, z),
                textured,
                relative);
        weigh();
    }

    private void weigh() {
        for (int band = 0; band < rgb.length; band++) {
            rgb[band] = isFiltered ? rgb[band] * relative[band] : relative[band];
        }
        isFiltered = true;
    }

    /** Whether an occluder hides a point of the light. */
    public boolean isBlocked(PhysicalLight l, LightSample to) {
        path.poll.tick();
        if (!start(to) && !isHidden && !tracer.occluded(ray, to.length, l)) {
            if (medium != null) {
                isFiltered = true;
                Arrays.fill(rgb, 1);
                medium.absorb(to.length, rgb);
            }
            return false;
        }
        if (walk == null) {
            return true;
        }
        start(to);
        isFiltered = true;
        return isOnTheWay
                ? !walk.reachesFromTheWay(l, ray, to.length, path, rgb)
                : !walk.reaches(l, ray, to.length, path, isBeyond, rgb);
    }

    /** Adds a light's radiance or intensity, times these factors and the transmittance. */
    void add(PhysicalLight l, double r, double g, double b, GatheredLight to) {
        if (isFiltered) {
            to.add(l, r * rgb[0], g * rgb[1], b * rgb[2]);
        } else {
            to.add(l, r, g, b);
        }
    }

    /** Starts the ray; returns whether a surface that coincides with the vertex occludes it. */
    private boolean start(LightSample to) {
        ray.set(x, y, z, to.dx, to.dy, to.dz, 0);
        return !isOnTheWay && Departure.from(path, ray, isInterface, isBeyond);
    }
}
