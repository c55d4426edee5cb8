package enlightenment.transport.bidirectional;

import enlightenment.bsdf.Bsdf;
import enlightenment.bsdf.Scattering;
import enlightenment.sampling.Sampler;
import enlightenment.transport.direct.InfiniteLight;
import enlightenment.transport.image.EyeImages;
import enlightenment.transport.ray.Optics;
import enlightenment.transport.ray.SegmentRays;
import enlightenment.transport.state.PathWavelength;
import enlightenment.world.CompiledScene;
import enlightenment.world.LightStarts;
import enlightenment.world.PhysicalScene;
import enlightenment.world.parts.RayCounters;
import enlightenment.world.surface.SurfaceInteraction;

/** Follows an eye subpath and gathers light at its vertices: from lights that it samples or hits, and from the vertices of a light subpath. */
final class BidirectionalGathering {
    /**
     * The mean number of connections of each path length, at most. Two long subpaths have a connection for each edge of a path of that
     * length, all alike and alike in weight; without this limit the cost would be quadratic where paths are long: in bright rooms, and in
     * media.
     */
    static final int PATHS_OF_A_LENGTH = 4;

    private final PhysicalScene physical;
    private final EyeSubpath eye;

    /** The wavelength of both subpaths; null if no glass of the scene disperses. */
    private final PathWavelength wavelength;

    final LightSubpath light;
    final BidirectionalLights lights;
    private final SegmentRays segments;

    /** Emission that the eye sees directly; null where the eye subpath continues another path. */
    private final EyeImages images;

    /** Next-event estimation of an environment map or a sky; null if the scene has none. */
    private final InfiniteLight infinite;

    private final Scattering there = new Scattering();
    private final ReverseDensity reverse = new ReverseDensity();

    /** Observes the strategies in tests; else null. */
    private Strategies strategies;

    /** The inverse of the probability with which the current vertex of the light subpath was selected for connection. */
    private double share;

    /** Whether connections pass nothing. */
    private boolean isDirect;

    /** Receives the light at the first vertex of the eye subpath in place of its {@link EyeSubpath#value}; null if nothing does. */
    LightDivision division;

    /**
     * @param images see {@link #images}
     */
    BidirectionalGathering(CompiledScene scene, RayCounters counters, EyeSubpath eye, EyeImages images) {
        physical = scene.physical;
        this.eye = eye;
        this.images = images;
        LightStarts starts = scene.lightStarts(false);
        wavelength = eye.path.glass.wavelength;
        light = new LightSubpath(scene, starts, counters);
        lights = new BidirectionalLights(scene, starts, counters, eye);
        infinite = InfiniteLight.of(scene, counters, eye.path);
        segments = new SegmentRays(scene, counters, eye.path);
    }

    /** Sets an observer of strategies, for tests. */
    void watch(Strategies by) {
        strategies = by;
    }

    /** Traces a light subpath. */
    void followLight(Sampler sampler) {
        boolean goes = light.begin(sampler);
        while (goes) {
            goes = light.step(sampler);
        }
    }

    /** Traces the eye subpath to its next vertex and gathers light there; returns whether it goes on. */
    boolean step(Sampler sampler) {
        switch (eye.next(sampler)) {
            case NOTHING:
                if (infinite == null) {
                    add(colors(false), 1, physical.backgroundR, physical.backgroundG, physical.backgroundB, 0);
                } else {
                    infinite.arrive(eye.ray, eye.state.hasDirect ? eye.state.pdf : 0, !eye.leavesHit(0));
                    addInfinite();
                }
                return false;
            case PASSED:
                return true;
            case SURFACE:
                glow();
                eye.passDye();
                break;
            case INTERFACE, MEDIUM:
                break;
            default:
                return false;
        }
        return scatter(sampler);
    }

    /** Gathers light at the current vertex of the eye subpath and lets it leave; returns whether it goes on. */
    boolean scatter(Sampler sampler) {
        if (!eye.mayScatter()) {
            return false;
        }
        if (!eye.bsdf.isDelta()) {
            gather(sampler);
        }
        return eye.leave(sampler);
    }

    /** Estimates light of an environment map or a sky, which only the eye subpath samples or hits ({@link InfiniteLight}). */
    private void gatherInfinite(Sampler sampler) {
        double[] tint = eye.isInterface ? eye.color : null;
        boolean isFirst = images != null && eye.isFirst();
        boolean leaves = eye.leavesSmallLights();
        infinite.gather(eye.bsdf, eye.s, tint, sampler, eye.state.address, isFirst, leaves);
        addInfinite();
    }

    private void addInfinite() {
        add(colors(false), 1, infinite.red, infinite.green, infinite.blue, 0);
    }

    /** Adds radiance, in the colour of the path's wavelength if isColored. */
    private void add(boolean isColored, double factor, double r, double g, double b, double ultraviolet) {
        if (division != null && eye.isFirst()) {
            division.divide(factor * r, factor * g, factor * b);
        } else if (isColored) {
            eye.value.add(factor * r * wavelength.red, factor * g * wavelength.green, factor * b * wavelength.blue);
        } else {
            eye.value.add(factor * r, factor * g, factor * b, factor * ultraviolet);
        }
    }

    /** Whether light at the eye subpath's last vertex has the wavelength's colour, before or after scattering there. */
    private boolean colors(boolean isScattered) {
        return wavelength != null && wavelength.colors(isScattered && eye.isInterface);
    }

    private double watched(int s, int t, double weight) {
        return strategies == null ? weight : strategies.weight(s, t, weight);
    }

    /** Adds emission that the eye sees directly, sampled apart. */
    void addSeenLight(EyeImages of) {
        add(false, watched(0, 2, 1), of.red, of.green, of.blue, 0);
    }

    /** Adds emission where the eye subpath has hit a light. */
    private void glow() {
        SurfaceInteraction at = eye.path.at;
        if (eye.glowing != null && eye.glowing.glowsTo(at.hit.side) && !eye.leavesHit(at.light)) {
            // Directly visible emission has no other strategy.
            double weight = watched(0, eye.vertices.size() + 1, eye.isFirst() ? 1 : lights.weightOfHit());
            weight *= images == null ? 1 : images.weight();
            at.findEmission();
            add(colors(false), weight, at.emittedR, at.emittedG, at.emittedB, at.emittedUltraviolet);
        }
    }

    private void gather(Sampler sampler) {
        int t = eye.vertices.size() + 1;
        if (eye.seesLamps() && lights.aim(sampler)) {
            double weight = watched(1, t, lights.weight);
            add(colors(true), weight, lights.red, lights.green, lights.blue, lights.ultraviolet);
        }
        connect(sampler, t);
        if (infinite != null && eye.seesLamps()) {
            gatherInfinite(sampler);
        }
    }

    /**
     * Connects vertices of the light subpath to the current vertex of the eye subpath: all of them for short paths, a share for longer
     * ones. Systematic sampling with one random number selects each with its exact probability, and nearly the same number each time.
     */
    void connect(Sampler sampler, int t) {
        int size = light.vertices.size();
        double drawn = size + t > PATHS_OF_A_LENGTH ? sampler.unit(eye.state.address, Sampler.Purpose.CONNECTION) : 0;
        for (int k = 0; k < size; k++) {
            double probability = (double) PATHS_OF_A_LENGTH / (k + 1 + t);
            share = 1;
            if (probability < 1) {
                drawn += probability;
                if (drawn < 1) {
                    continue;
                }
                drawn--;
                share = 1 / probability;
            }
            mayConnect(k, t);
        }
    }

    private void mayConnect(int k, int t) {
        if (light.vertices.bsdf(k) != null
                && light.vertices.bounces(k) + eye.path.bounces() + 2 <= physical.maxBounces) {
            connect(k, t);
        }
    }

    /**
     * Connects a vertex of the light subpath to the current vertex, the first of the eye subpath, where nothing lies between them, not even
     * a pane.
     */
    void connectFirst(int k) {
        share = 1;
        isDirect = true;
        mayConnect(k, 1);
        isDirect = false;
    }

    /** Connects a vertex of the light subpath to the current vertex of the eye subpath. */
    private void connect(int k, int t) {
        PathVertices v = light.vertices;
        Scattering s = eye.s;
        double x = v.x(k) - eye.path.at.hit.px;
        double y = v.y(k) - eye.path.at.hit.py;
        double z = v.z(k) - eye.path.at.hit.pz;
        double d2 = x * x + y * y + z * z;
        double d = Math.sqrt(d2);
        s.ix = x / d;
        s.iy = y / d;
        s.iz = z / d;
        double here = s.geometricCosineIn();
        if (!(d > 0) || !(eye.isInterface || eye.isMedium || here > 0)) {
            return;
        }
        Bsdf bsdf = v.bsdf(k);
        v.get(k, there);
        there.ix = -s.ix;
        there.iy = -s.iy;
        there.iz = -s.iz;
        double beyond = there.geometricCosineIn();
        if (!(bsdf.transmits() || beyond > 0)) {
            return;
        }
        evaluate(bsdf, beyond);
        double r = s.valueR * there.valueR * v.red(k) / d2;
        double g = s.valueG * there.valueG * v.green(k) / d2;
        double b = s.valueB * there.valueB * v.blue(k) / d2;
        double u = s.valueB * there.valueB * v.ultraviolet(k) / d2;
        if (!(r > 0 || g > 0 || b > 0 || u > 0)) {
            return;
        }
        segments.begin(eye.isInterface, here < 0);
        boolean reaches = isDirect
                ? segments.reachesDirectly(s.ix, s.iy, s.iz, d, v.id(k), v.face(k))
                : segments.reaches(s.ix, s.iy, s.iz, d, v.id(k), v.face(k));
        if (reaches) {
            double weight = share * watched(k + 2, t, weight(k, here, beyond, d2));
            boolean isColored = wavelength != null && (colors(true) || v.isColored(k));
            double[] left = segments.rgb;
            add(isColored, weight, r * left[0], g * left[1], b * left[2], u * left[2]);
        }
    }

    /** Evaluates the BSDFs of both vertices for the edge between them. */
    private void evaluate(Bsdf bsdf, double beyond) {
        eye.bsdf.evaluate(eye.s);
        if (eye.isInterface) {
            Optics.turn(eye.s, eye.color);
        }
        bsdf.evaluate(there);
        if (beyond < 0) {
            // The colours of an interface are those of transmitted light.
            there.valueR *= there.red;
            there.valueG *= there.green;
            there.valueB *= there.blue;
        }
    }

    /** The MIS weight of connecting the two vertices whose BSDFs were evaluated. */
    private double weight(int k, double here, double beyond, double d2) {
        PathVertices v = light.vertices;
        double q = v.survival(k);
        double area = d2 / physical.areaUnit;
        double toLight = eye.survival * eye.s.pdf * v.projected(k, beyond) / area;
        double toEye = q * there.pdf * eye.projected(here) / area;
        double ofLight = SubpathDensities.square(toLight) * v.behind(k, q * reverse.of(v.bsdf(k), there));
        double ofEye =
                SubpathDensities.square(toEye) * eye.densities.behind(eye.survival * reverse.of(eye.bsdf, eye.s));
        return SubpathDensities.weight(ofLight, ofEye);
    }
}
