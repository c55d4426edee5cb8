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
 * Follows a path from event to event, through surfaces and media: says what comes next, and lets whoever shades decide what that is
 * worth and where the path goes on. One per thread.
 */
public final class PathFollower {

    /** What a path comes to. */
    public enum Event {
        /** It leaves the scene. */
        NOTHING,
        /** {@link #light}. */
        LIGHT,
        /** An opaque surface: {@link #at}. */
        SURFACE,
        /** Surfaces of glass, to be {@link #cross crossed}. */
        GLASS
    }

    public final Tracer tracer;
    public final GlassTracer glass;
    public final Poll poll;

    /** The surface that the path is at. */
    public final SurfaceInteraction at = new SurfaceInteraction();

    /** The light that the path came to. */
    public ClassicLight light;

    /** A hash of what the path came to, in order. */
    public long key;

    /** How many surfaces the path has left behind. */
    public int surfaces;

    private final CompiledScene scene;

    /** The material of what fills the whole scene outside of solids, or null. */
    private final SurfaceMaterial around;

    private final RayCounters counters;
    private final Scattering scattering = new Scattering();
    private final double[] tint = new double[3];
    private final PathLength bounces;

    /** Whether there are surfaces with holes. */
    private final boolean hasMasks;

    /** How far the last ray went to the last of the holes that it passed. */
    private double passed;

    /** Whether the surface that the path is at coincides with the one before. */
    private boolean tookNext;

    /** Whether the last event was glass that did not turn the ray. */
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

    /** Draws the wavelength of a path that begins next, where it matters. */
    public void drawWavelength(Sampler sampler) {
        if (glass.wavelength != null) {
            glass.wavelength.begin(sampler);
        }
    }

    /** Starts a path of physical shading with a camera ray. */
    public void begin(Ray ray, Sampler sampler) {
        drawWavelength(sampler);
        begin(ray);
    }

    /** Starts a path with a camera ray. */
    public void begin(Ray ray) {
        counters.cameraRays++;
        beginAgain(ray);
    }

    /** The same with one that is not counted, as it begins no sample. */
    public void beginAgain(Ray ray) {
        beginFrom(false);
        glass.begin(ray, scene.cameraSolids, null);
        begin(0);
    }

    /**
     * Starts a path with a ray that leaves a light.
     *
     * @param source it has just been emitted there
     */
    public void beginAtLight(Ray ray, PathSource source) {
        beginFrom(true);
        glass.begin(ray, source.media(), source.faces());
        begin(1);
    }

    /**
     * Starts a shadow ray in the medium that a path is in, or behind the rough border that it is at.
     *
     * @param ray it has departed from the vertex that the path is at
     */
    void beginShadow(PathFollower from, Ray ray, boolean isBeyond) {
        glass.begin(from.glass, isBeyond);
        begin(1);
        if (!isBeyond && from.glass.entersAtOnce()) {
            glass.settle(ray, from.at.id);
        }
    }

    /** Starts a shadow ray in the medium that a path is flying through, whatever that has come to. */
    void beginShadowOnTheWay(PathFollower from) {
        glass.beginOnTheWay(from.glass);
        begin(1);
    }

    private void beginFrom(boolean light) {
        scattering.fromLight = light;
        glass.border.fromLight = light;
    }

    private void begin(int left) {
        key = 0;
        surfaces = left;
        bounces.begin();
        passedStraight = false;
        poll.tick();
    }

    /** Follows the ray to what it meets next. */
    public Event next(Ray ray) {
        passed = 0;
        Event event = meet(ray);
        while (hasMasks && event == Event.SURFACE && isAtHole()) {
            // Nothing is there: neither an event nor a bounce, but the path has left a surface behind.
            passed += distanceOfHit(ray);
            // The ray behind it starts at 0, wherever this one does.
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

    /** Writes the colour of that surface. */
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
     * Lets the ray leave an opaque surface in a direction that its material samples, from a point (u, v) of the unit square and a number
     * that chooses the lobe.
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

    /** The opaque surface that the path is at, as a Bsdf wants it: with its colour, and without a direction to go on. */
    public Scattering arrive(Ray ray, double[] color) {
        Optics.arrive(scattering, ray, at);
        scattering.red = color[0];
        scattering.green = color[1];
        scattering.blue = color[2];
        return scattering;
    }

    /** Lets the ray leave that surface in the direction that was sampled. */
    public void leave(Ray ray, Scattering s) {
        Optics.leave(ray, at.hit, s);
        glass.startOnAll(ray);
        glass.settle(ray, at.id);
    }

    /**
     * As {@link #scatter} at a Lambertian surface, whose colour is the weight. If the density is 0 the path ends.
     *
     * @return the direction, and its density
     */
    public Scattering scatterMatte(Ray ray, double u, double v) {
        scattering.nx = at.nx;
        scattering.ny = at.ny;
        scattering.nz = at.nz;
        scattering.sampleMatte(u, v);
        leave(ray, scattering);
        return scattering;
    }

    /** How far the ray went to what {@link #next} found: nowhere if that coincides with the glass that it left. */
    public double distance(Ray ray) {
        return passed + distanceOfHit(ray);
    }

    private double distanceOfHit(Ray ray) {
        return tookNext ? 0 : (at.hit.t - ray.tMin) * Math.sqrt(ray.dd);
    }

    /**
     * The same for a ray that goes no further than this, in lengths of the frame: {@link Event#NOTHING} if it meets nothing on that way.
     */
    public Event next(Ray ray, double length) {
        tracer.limit = Math.min(ray.tMin + length / Math.sqrt(ray.dd), Double.MAX_VALUE);
        Event event = next(ray);
        tracer.limit = Double.MAX_VALUE;
        return event;
    }

    /**
     * Stops on the way, after a length, in the medium that the ray is in: the path is at no surface then.
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

    /** The material of the medium that the ray is in, or null in empty space. */
    public SurfaceMaterial medium() {
        return medium(false);
    }

    /** The same, or that behind the rough border that the path is at. */
    public SurfaceMaterial medium(boolean isBeyond) {
        int solid = glass.medium(isBeyond);
        return solid < 0 ? around : scene.inside(solid);
    }

    /** How glass scatters where the path is at a rough border of two media, and where; null elsewhere. */
    public Bsdf roughBorder(Ray ray, Scattering s) {
        return glass.roughBorder(ray, at.hit, s);
    }

    /** How many scattering events it has had. */
    public int bounces() {
        return bounces.bounces();
    }

    /** Whether the path may have one more scattering event. */
    public boolean mayScatter() {
        return bounces.mayScatter(1);
    }

    /** Whether it may have two more. */
    public boolean mayScatterTwice() {
        return bounces.mayScatter(2);
    }

    /**
     * Lets the ray pass, be refracted or be reflected at the surfaces of glass that it came to.
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
     * Lets a shadow ray pass the surfaces of glass that it came to, if they do not turn it.
     *
     * @param rgb is multiplied by the share that passes
     * @return whether it did
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
        return goesOn();
    }

    /** Multiplies by the colours of the glass that the ray was just transmitted by. */
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

    /** Turns to one of the surfaces that coincide here. */
    public void turnTo(int k) {
        at.hit.set(glass.hitOf(k));
        at.arrive(scene, glass.surface(k));
    }

    /** Turns to one of them, of glass, where {@link GlassTracer#opaque} finds it opaque. */
    public void turnToOpaque(int k) {
        turnTo(k);
        at.becomeOpaque();
    }

    /**
     * Counts the event that the path leaves behind. Surfaces that do not turn the ray are no bounces, so cutting a scene into more
     * pieces changes nothing.
     *
     * @return whether the path may go on
     */
    public boolean goesOn() {
        surfaces++;
        boolean goesOn = passedStraight ? bounces.passed() : bounces.bounced();
        passedStraight = false;
        if (!goesOn) {
            return false;
        }
        poll.tick();
        return true;
    }
}
