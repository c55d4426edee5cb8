package enlightenment.transport.bidirectional;

import enlightenment.bsdf.Bsdf;
import enlightenment.bsdf.GlossyReflection;
import enlightenment.bsdf.Reradiation;
import enlightenment.bsdf.Scattering;
import enlightenment.bsdf.SmoothShading;
import enlightenment.primitive.Hit;
import enlightenment.sampling.Sampler;
import enlightenment.transport.ray.PathFollower;
import enlightenment.transport.state.PathEvent;
import enlightenment.transport.state.PathState;
import enlightenment.transport.state.PathValue;
import enlightenment.transport.state.Throughput;
import enlightenment.world.CompiledScene;
import enlightenment.world.material.SurfaceMaterial;
import enlightenment.world.parts.RayCounters;
import java.util.Arrays;

/**
 * A subpath from the eye or from a light, traced from vertex to vertex, with the densities that MIS weights of all strategies need. Russian
 * roulette depends on the surface alone, from the first vertex on, so that the survival probability of the reverse path is known, too. One
 * per thread.
 */
abstract class Subpath extends CarriedLight {
    /** The kinds of vertices of a subpath. */
    public enum Event {
        /** The ray leaves the scene. */
        NOTHING,
        /** An opaque surface. */
        SURFACE,
        /** A rough interface of two media. */
        INTERFACE,
        /** A point of a medium that scatters light. */
        MEDIUM,
        /** The path has passed smooth glass, or was reflected by it, and goes on. */
        PASSED,
        /** The path ends. */
        ENDED
    }

    public final SubpathDensities densities = new SubpathDensities();

    /** The vertices so far. */
    public PathVertices vertices = new PathVertices();

    /** The scattering at the current vertex, with its colour. */
    public Scattering s;

    public Bsdf bsdf;

    /** Whether the current vertex is on a rough interface of two media. */
    public boolean isInterface;

    /** The colour of the current surface; at an interface that of transmitted light. */
    public final double[] color = new double[3];

    /** The material of the current surface if it emits light; null if not. */
    SurfaceMaterial glowing;

    /** The survival probability of Russian roulette at the current vertex. */
    public double survival;

    /** The scattering events so far. */
    public final PathState state = new PathState();

    /** The last vertex before the current one, and its normal; (0, 0, 0) at an interface. */
    int lastId;

    double lastX;

    double lastY;
    double lastZ;
    double lastNx;
    double lastNy;
    double lastNz;

    final ReverseDensity reverse = new ReverseDensity();
    private final RayCounters counters;
    private final Scattering atInterface = new Scattering();
    private final double[] pair = new double[2];
    private final double[] weight = new double[3];
    private final Sampler.Purpose choosing;
    private final Sampler.Purpose directing;
    private final Sampler.Purpose surviving;
    private double choice;

    /** {@link SubpathDensities#beyond} before the path arrived at the current surface, for delta events. */
    private double beyondDelta;

    Subpath(
            CompiledScene scene,
            RayCounters counters,
            PathFollower path,
            Throughput throughput,
            Sampler.Purpose choosing,
            Sampler.Purpose directing,
            Sampler.Purpose surviving,
            Sampler.Purpose flying) {
        super(scene, path, throughput, flying);
        this.counters = counters;
        this.choosing = choosing;
        this.directing = directing;
        this.surviving = surviving;
    }

    void begin() {
        state.begin();
        vertices.clear();
        if (inMedium != null) {
            inMedium.begin();
        }
    }

    /** Whether the current vertex is the path's first. */
    final boolean isFirst() {
        return state.events == 0;
    }

    /**
     * Sets the densities at the path's first vertex, given by {@link #s} and the follower's hit.
     *
     * @param cosine between the normal and the direction that the path came from; in a medium {@link MediumVertex#density}
     */
    abstract void beginDensities(double cosine);

    /** Sets the densities of a path whose first vertex is a delta event. */
    abstract void beginDensitiesOfDelta();

    /** Scatters the path at a fluorescent surface of this {@link #color}; the path goes on as at a white one. */
    abstract void reradiate(Reradiation by);

    /** Called when the path enters a medium with this index of refraction. */
    abstract void enter(double index);

    /** Whether light of small lights at the current vertex is left to the caustic pass. */
    boolean leavesSmallLights() {
        return false;
    }

    /** Traces the path to its next vertex. */
    public Event next(Sampler sampler) {
        PathFollower.Event event = meet(sampler);
        if (event == null) {
            return scattered();
        }
        if (event == PathFollower.Event.NOTHING) {
            return Event.NOTHING;
        }
        return event == PathFollower.Event.SURFACE ? surface() : glass(sampler);
    }

    /** Makes the point where a medium scatters the path the current vertex. */
    private Event scattered() {
        isInterface = false;
        glowing = null;
        Arrays.fill(color, 1);
        s = inMedium.event;
        bsdf = inMedium.phase();
        survival = inMedium.survival();
        arrive();
        return Event.MEDIUM;
    }

    /** Makes the opaque surface that the path has hit the current vertex. */
    final Event surface() {
        if (inMedium != null) {
            inMedium.flight.begin();
        }
        SurfaceMaterial material = path.at.material;
        glowing = material.glows ? material : null;
        opaque(material, path.at.bsdf);
        return Event.SURFACE;
    }

    private void opaque(SurfaceMaterial material, Bsdf scatters) {
        path.color(material, color);
        double most = Math.max(color[0], Math.max(color[1], color[2]));
        if (material.reradiation != null) {
            most = material.reradiation.most(color, physical.hasUltraviolet);
            reradiate(material.reradiation);
            Arrays.fill(color, 1);
        }
        s = path.arrive(ray, color);
        bsdf = scatters;
        isInterface = false;
        survival = survival(most);
        Bsdf made = bsdf instanceof SmoothShading smooth ? smooth.inner() : bsdf;
        if (made instanceof GlossyReflection metal) {
            // Metals reflect more at grazing incidence.
            metal.reflectAtNormal(s);
            survival = survival(0.5 + 0.5 * Math.max(s.valueR, Math.max(s.valueG, s.valueB)));
        } else if (made.hasDelta() || made.reflectsIfBlack()) {
            // The coat reflects light that its base does not.
            survival = survival(0.5 + 0.5 * most);
        }
        if (material.isBlack) {
            survival = 0;
        } else if (bsdf.isDelta()) {
            survival = 1;
        }
        arrive();
    }

    /** The square root makes paths longer than the colour itself would, which pays: docs/notes/bidirectional.md. */
    private static double survival(double most) {
        return Math.min(Math.sqrt(most), PathValue.LARGEST_SURVIVAL);
    }

    /** Whether the path may be scattered at the current vertex. */
    public boolean mayScatter() {
        return survival > 0 && path.mayScatter();
    }

    private void arrive() {
        Hit at = path.at.hit;
        double cosine = SubpathDensities.cosine(projected(s.geometricCosineOut()));
        boolean isDelta = bsdf.isDelta();
        boolean isFirst = isFirst();
        if (isFirst && isDelta) {
            beginDensitiesOfDelta();
        } else if (isFirst) {
            beginDensities(cosine);
        }
        beyondDelta = densities.beyond;
        if (!isFirst) {
            double x = at.px - lastX;
            double y = at.py - lastY;
            double z = at.pz - lastZ;
            densities.arrive((x * x + y * y + z * z) / physical.areaUnit, cosine);
        }
        if (isDelta) {
            vertices.addDelta(at, 1);
        } else {
            vertices.add(at, path.at.id, bsdf, s, color, path.bounces(), densities, survival);
            vertices.power(throughput);
            vertices.medium(isMedium ? inMedium.density() : 0);
            if (path.glass.wavelength != null) {
                vertices.colored(path.glass.wavelength.colors(isInterface));
            }
        }
    }

    private void passDelta(double expansion) {
        if (isFirst()) {
            beginDensitiesOfDelta();
        }
        densities.pass(expansion);
        vertices.addDelta(path.at.hit, expansion);
    }

    private Event glass(Sampler sampler) {
        sampler.pair(state.address, choosing, pair);
        choice = pair[0];
        glowing = null;
        if (physical.hasPartialGlass) {
            int k = path.glass.opaque(pair[1]);
            if (k >= 0) {
                path.turnToOpaque(k);
                opaque(path.at.material, path.at.bsdf);
                return Event.SURFACE;
            }
        }
        // An opaque surface that coincides with the interface has no distance from it: the path goes on as through
        // smooth glass.
        boolean isApart = !path.glass.comesToOpaque(true) && !path.glass.comesToOpaque(false);
        boolean mayConnect = physical.hasRoughGlass && isApart && path.mayScatter();
        Bsdf rough = mayConnect ? path.roughInterface(ray, atInterface) : null;
        if (rough == null) {
            return pass(sampler);
        }
        bsdf = rough;
        s = atInterface;
        isInterface = true;
        survival = PathValue.LARGEST_SURVIVAL;
        Arrays.fill(color, 1);
        path.filter(color);
        path.turnTo(0);
        arrive();
        return Event.INTERFACE;
    }

    /** Scatters the path at smooth glass. */
    private Event pass(Sampler sampler) {
        if (physical.hasRoughGlass) {
            sampler.pair(state.address, directing, pair);
        }
        path.glass.choose(choice, pair);
        cross();
        if (path.glass.passedStraight()) {
            state.address++;
            throughput.filter(weight[0], weight[1], weight[2]);
            return path.continues() ? Event.PASSED : Event.ENDED;
        }
        Scattering b = path.glass.atInterface;
        passDelta(b.transmitted ? b.eta * b.eta : 1);
        remember(b, false);
        boolean goes = survives(sampler, survival(Math.max(weight[0], Math.max(weight[1], weight[2]))));
        state.address++;
        return goes && path.continues() ? Event.PASSED : Event.ENDED;
    }

    /** Transmits or reflects the path at the glass that it is at. */
    private void cross() {
        boolean through = path.cross(ray);
        Arrays.fill(weight, path.glass.weight());
        if (through) {
            path.filter(weight);
        }
        enter(path.glass.indexOfRefraction());
    }

    private void remember(Scattering at, boolean connects) {
        if (connects) {
            state.extend(
                    isMedium ? PathEvent.MEDIUM : isInterface ? PathEvent.ROUGH_INTERFACE : PathEvent.WIDE,
                    at,
                    leavesSmallLights());
        } else {
            state.extendSpecular(-1);
        }
        lastId = path.at.id;
        lastX = path.at.hit.px;
        lastY = path.at.hit.py;
        lastZ = path.at.hit.pz;
        boolean takesFromAllSides = isInterface && connects;
        lastNx = takesFromAllSides ? 0 : at.gx;
        lastNy = takesFromAllSides ? 0 : at.gy;
        lastNz = takesFromAllSides ? 0 : at.gz;
    }

    /** Samples the direction in which the path leaves the current surface or interface; returns whether it goes on. */
    public boolean leave(Sampler sampler) {
        sampler.pair(state.address, directing, pair);
        boolean goes = isMedium ? leaveMedium(sampler) : isInterface ? leaveInterface(sampler) : leaveSurface(sampler);
        state.address++;
        return goes && path.continues();
    }

    private boolean leaveSurface(Sampler sampler) {
        if (!bsdf.sample(s, pair[0], pair[1], sampler.unit(state.address, choosing))) {
            return false;
        }
        boolean wasFirst = isFirst();
        remember(s, !s.delta);
        weight[0] = s.valueR;
        weight[1] = s.valueG;
        weight[2] = s.valueB;
        if (s.delta) {
            counters.mirrorRays++;
            survival = survival(Math.max(s.valueR, Math.max(s.valueG, s.valueB)));
            if (wasFirst) {
                beginDensitiesOfDelta();
            } else {
                densities.beyond = beyondDelta;
            }
            densities.pass(1);
        } else {
            leave(s);
        }
        path.leave(ray, s);
        return survives(sampler, survival);
    }

    private boolean leaveMedium(Sampler sampler) {
        bsdf.sample(s, pair[0], pair[1], 0);
        remember(s, true);
        Arrays.fill(weight, 1);
        leave(s);
        ray.set(path.at.hit.px, path.at.hit.py, path.at.hit.pz, s.ix, s.iy, s.iz, 0);
        return survives(sampler, survival);
    }

    private boolean leaveInterface(Sampler sampler) {
        path.glass.choose(choice, pair);
        cross();
        if (!(path.glass.weight() > 0)) {
            return false;
        }
        remember(path.glass.atInterface, true);
        leave(path.glass.atInterface);
        return survives(sampler, survival);
    }

    private void leave(Scattering at) {
        double cosine = projected(at.geometricCosineIn());
        densities.leave(cosine, survival * at.pdf, survival * reverse.of(bsdf, at));
    }

    private boolean survives(Sampler sampler, double probability) {
        if (!(probability > 0) || !(sampler.unit(state.address, surviving) < probability)) {
            return false;
        }
        double scale = 1 / probability;
        throughput.filter(scale * weight[0], scale * weight[1], scale * weight[2]);
        return throughput.isLit();
    }
}
