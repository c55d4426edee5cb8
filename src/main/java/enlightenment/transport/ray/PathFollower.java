package enlightenment.transport.ray;

import enlightenment.bsdf.Bsdf;
import enlightenment.bsdf.Scattering;
import enlightenment.primitive.Hit;
import enlightenment.primitive.Ray;
import enlightenment.sampling.Hash;
import enlightenment.sampling.Sampler;
import enlightenment.world.CompiledScene;
import enlightenment.world.Tracer;
import enlightenment.world.light.ClassicLight;
import enlightenment.world.material.SurfaceMaterial;
import enlightenment.world.parts.RayCounters;
import enlightenment.world.surface.SurfaceInteraction;

/**
 * Follows a path from event to event through surfaces and media. It finds the next event; the caller shades there and chooses how the path
 * goes on. One per thread.
 */
public final class PathFollower {

    /** What the ray of a path meets next. */
    public enum Event {
        /** The ray leaves the scene. */
        NOTHING,
        /** A light of classic shading: {@link #light}. */
        LIGHT,
        /** An opaque surface: {@link #at}. */
        SURFACE,
        /** Surfaces of glass, to be {@link #cross crossed}. */
        GLASS
    }

    /** The solids around a point in empty space. */
    private static final int[] NOWHERE = {};

    public final Tracer tracer;
    public final GlassTracer glass;
    public final Poll poll;

    /** The surface of the last event. */
    public final SurfaceInteraction at = new SurfaceInteraction();

    /** The light of the last event, if that is {@link Event#LIGHT}. */
    public ClassicLight light;

    /** A hash of the events so far, in order. */
    public long key;

    /** The number of surfaces that the path has left; light paths and shadow rays begin with 1. */
    public int surfaces;

    private final CompiledScene scene;

    /** The ambient medium: the material that fills the scene outside of solids; null if empty space does. */
    private final SurfaceMaterial around;

    private final RayCounters counters;
    private final Scattering scattering = new Scattering();
    private final double[] tint = new double[3];
    private final PathLength bounces;

    /** Whether the scene has surfaces with alpha masks. */
    private final boolean hasMasks;

    /** The length from the ray's origin to the last hole that it passed, in the frame; 0 if none. */
    private double passed;

    /** Whether the current surface coincides with the previous one. */
    private boolean tookNext;

    /** Whether the last event was at glass and kept the ray's direction. */
    private boolean passedStraight;

    public PathFollower(CompiledScene scene, RayCounters counters, int maxBounces) {
        this.scene = scene;
        around = scene.physical == null ? null : scene.physical.around;
        this.counters = counters;
        hasMasks = scene.physical != null && scene.physical.hasMasks;
        bounces = new PathLength(maxBounces, scene.crossings);
        tracer = new Tracer(scene, counters);
        glass = new GlassTracer(scene, counters);
        poll = new Poll();
    }

    /** Samples the wavelength of the next path, if any glass of the scene disperses. */
    public void drawWavelength(Sampler sampler) {
        if (glass.wavelength != null) {
            glass.wavelength.begin(sampler);
        }
    }

    /** Begins a path of physical shading at a camera ray: samples its wavelength and counts a camera ray. */
    public void begin(Ray ray, Sampler sampler) {
        drawWavelength(sampler);
        begin(ray);
    }

    /** Begins a path at a camera ray, which is counted. */
    public void begin(Ray ray) {
        counters.cameraRays++;
        beginAgain(ray);
    }

    /** Begins a path at a camera ray that begins no sample, so that it is not counted. */
    public void beginAgain(Ray ray) {
        beginFrom(false);
        glass.begin(ray, scene.cameraSolids, null);
        begin(0);
    }

    /**
     * Begins again on the ray by which a path of physical shading has left its first surface, an opaque one in empty space, so that the
     * path has had one scattering event.
     */
    public void resume(Ray ray) {
        beginFrom(false);
        glass.begin(ray, NOWHERE, null);
        begin(1);
        bounces.bounced();
    }

    /**
     * Begins a path at a light.
     *
     * @param source has just emitted the ray
     */
    public void beginAtLight(Ray ray, PathSource source) {
        beginFrom(true);
        glass.begin(ray, source.media(), source.faces());
        begin(1);
    }

    /**
     * Begins a shadow ray in the medium of a path; if isBeyond, in that behind the rough interface that it is at.
     *
     * @param ray has departed from the path's current vertex
     */
    void beginShadow(PathFollower from, Ray ray, boolean isBeyond) {
        glass.begin(from.glass, isBeyond);
        begin(1);
        if (!isBeyond && from.glass.entersAtOnce()) {
            glass.settle(ray, from.at.id);
        }
    }

    /** Begins a shadow ray in the medium of a path, at a point of its flight before the surface that it has hit since. */
    void beginShadowOnTheWay(PathFollower from) {
        glass.beginOnTheWay(from.glass);
        begin(1);
    }

    private void beginFrom(boolean light) {
        scattering.fromLight = light;
        glass.atInterface.fromLight = light;
    }

    private void begin(int left) {
        key = 0;
        surfaces = left;
        bounces.begin();
        passedStraight = false;
        poll.tick();
    }

    /** Traces the ray to its next event. */
    public Event next(Ray ray) {
        passed = 0;
        Event event = meet(ray);
        while (hasMasks && event == Event.SURFACE && isAtHole()) {
            // The path passes a hole: no event and no bounce, but it has left a surface.
            passed += distanceOfHit(ray);
            // The ray behind the hole starts at parameter 0, wherever this one starts.
            tracer.limit -= at.hit.t;
            surfaces++;
            Optics.pass(ray, at.hit);
            glass.startBehindHole(ray);
            event = bounces.passed() ? meet(ray) : Event.NOTHING;
        }
        return event;
    }

    private boolean isAtHole() {
        SurfaceMaterial whole = scene.material(at.id, at.hit.face);
        return whole.detail != null && at.isHole(whole);
    }

    private Event meet(Ray ray) {
        Hit hit = at.hit;
        int struck = glass.takeNext(hit);
        tookNext = struck >= 0;
        if (!tookNext) {
            if (!(surfaces == 0 ? tracer.traceCamera(ray, hit) : tracer.trace(ray, hit))) {
                return Event.NOTHING;
            }
            light = tracer.light;
            if (light != null) {
                key = Hash.mix(key + 1);
                return Event.LIGHT;
            }
            struck = tracer.id;
        }
        key = Hash.mix(key - 1 - struck - ((long) hit.face << 32));
        boolean isGlass = glass.arrive(ray, struck, hit);
        at.arrive(scene, glass.id);
        return isGlass ? Event.GLASS : Event.SURFACE;
    }

    /** Writes the colour of the current surface, by band. */
    public void color(SurfaceMaterial material, double[] rgb) {
        if (!material.isTextured()) {
            material.color(rgb);
            return;
        }
        if (material.hasImage()) {
            counters.textureLookups++;
        }
        Hit hit = at.hit;
        hit.primitive.textureCoordinates(hit);
        material.color(hit.u, hit.v, hit.primitive.repeatsTextures(), rgb);
    }

    /**
     * Samples the direction in which the ray leaves an opaque surface, by a point (u, v) of the unit square and a number that selects the
     * lobe.
     *
     * @param color the surface's colour; receives the weight of the direction, by which the path's throughput changes
     * @return false if the path ends here
     */
    public boolean scatter(Ray ray, SurfaceMaterial material, double[] color, double u, double v, double choice) {
        arrive(ray, color);
        if (!at.bsdf.sample(scattering, u, v, choice)) {
            return false;
        }
        color[0] = scattering.valueR;
        color[1] = scattering.valueG;
        color[2] = scattering.valueB;
        counters.mirrorRays += scattering.delta ? 1 : 0;
        leave(ray, scattering);
        return true;
    }

    /** Whether {@link #scatter} sampled a delta lobe. */
    public boolean isSpecular() {
        return scattering.delta;
    }

    /** Sets the scattering at the current opaque surface: its colour, normals and the direction that the path came from. */
    public Scattering arrive(Ray ray, double[] color) {
        Optics.arrive(scattering, ray, at);
        scattering.red = color[0];
        scattering.green = color[1];
        scattering.blue = color[2];
        return scattering;
    }

    /** Sets the ray to leave the current surface in the sampled direction. */
    public void leave(Ray ray, Scattering s) {
        Optics.leave(ray, at.hit, s);
        glass.startOnAll(ray);
        glass.settle(ray, at.id);
    }

    /** Samples a direction and its density at a Lambertian surface, whose weight is its colour; at density 0 the path ends. */
    public Scattering scatterMatte(Ray ray, double u, double v) {
        scattering.nx = at.nx;
        scattering.ny = at.ny;
        scattering.nz = at.nz;
        scattering.sampleMatte(u, v);
        leave(ray, scattering);
        return scattering;
    }

    /** The length that the ray went to its last event, in the frame; 0 if that coincides with the glass that it left. */
    public double distance(Ray ray) {
        return passed + distanceOfHit(ray);
    }

    private double distanceOfHit(Ray ray) {
        return tookNext ? 0 : (at.hit.t - ray.tMin) * Math.sqrt(ray.dd);
    }

    /** Traces the ray to its next event within a length, in the frame; {@link Event#NOTHING} if there is none. */
    public Event next(Ray ray, double length) {
        tracer.limit = Math.min(ray.tMin + length / Math.sqrt(ray.dd), Double.MAX_VALUE);
        Event event = next(ray);
        tracer.limit = Double.MAX_VALUE;
        return event;
    }

    /**
     * Sets the position to a point of the ray in its current medium, at a length in the frame; the path is at no surface then.
     *
     * @param s receives the direction that the path came from
     */
    public void stopAt(Ray ray, double length, Scattering s) {
        double scale = 1 / Math.sqrt(ray.dd);
        s.ox = -ray.dx * scale;
        s.oy = -ray.dy * scale;
        s.oz = -ray.dz * scale;
        at.arriveInMedium(
                Math.fma(passed - length, s.ox, Math.fma(ray.tMin, ray.dx, ray.ox)),
                Math.fma(passed - length, s.oy, Math.fma(ray.tMin, ray.dy, ray.oy)),
                Math.fma(passed - length, s.oz, Math.fma(ray.tMin, ray.dz, ray.oz)));
        glass.leaveSurfaces();
    }

    /** The material of the current medium; null in empty space. */
    public SurfaceMaterial medium() {
        return medium(false);
    }

    /** The material of the current medium or, if isBeyond, that behind the rough interface; null in empty space. */
    public SurfaceMaterial medium(boolean isBeyond) {
        int solid = glass.medium(isBeyond);
        return solid < 0 ? around : scene.inside(solid);
    }

    /** The scattering function where the path is at a rough interface of two media, with s set; null elsewhere. */
    public Bsdf roughInterface(Ray ray, Scattering s) {
        return glass.roughInterface(ray, at.hit, s);
    }

    /** The number of scattering events of the path. */
    public int bounces() {
        return bounces.bounces();
    }

    /** Whether the limit of bounces admits one more scattering event. */
    public boolean mayScatter() {
        return bounces.mayScatter(1);
    }

    /** Whether the limit of bounces admits two more scattering events. */
    public boolean mayScatterTwice() {
        return bounces.mayScatter(2);
    }

    /**
     * Passes, refracts or reflects the ray at the surfaces of glass that it has hit.
     *
     * @return whether it was transmitted
     */
    public boolean cross(Ray ray) {
        boolean through = glass.cross(ray, at.hit);
        passedStraight = glass.passedStraight();
        key += through ? 1 : 0;
        return through;
    }

    /**
     * Lets a shadow ray pass the surfaces of glass that it has hit, if they do not change its direction.
     *
     * @param rgb is multiplied by the transmittance, by band
     * @return whether the ray passed
     */
    boolean passStraight(Ray ray, double[] rgb) {
        double share = glass.passStraight(ray, at.hit);
        if (!(share > 0)) {
            return false;
        }
        share = glass.clear(share);
        for (int c = 0; c < rgb.length; c++) {
            rgb[c] *= share;
        }
        filter(rgb);
        passedStraight = true;
        return continues();
    }

    /** Multiplies by the colours of the glass that has just transmitted the ray. */
    public void filter(double[] rgb) {
        for (int k = 0; k < glass.surfaces(); k++) {
            if (glass.filters(k, true)) {
                turnTo(k);
                color(at.material, tint);
                rgb[0] *= tint[0];
                rgb[1] *= tint[1];
                rgb[2] *= tint[2];
            }
        }
    }

    /** Makes coincident surface k the current one. */
    public void turnTo(int k) {
        at.hit.set(glass.hitOf(k));
        at.arrive(scene, glass.surface(k));
    }

    /** Makes coincident surface k, of glass, the current one; {@link GlassTracer#opaque} has found it opaque. */
    public void turnToOpaque(int k) {
        turnTo(k);
        at.becomeOpaque();
    }

    /**
     * Counts the current event. Surfaces that keep the direction are no bounces, so that cutting an object into pieces changes nothing.
     *
     * @return whether the path may go on
     */
    public boolean continues() {
        surfaces++;
        boolean continues = passedStraight ? bounces.passed() : bounces.bounced();
        passedStraight = false;
        if (!continues) {
            return false;
        }
        poll.tick();
        return true;
    }
}
