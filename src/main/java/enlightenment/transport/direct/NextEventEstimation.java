package enlightenment.transport.direct;

import enlightenment.bsdf.Bsdf;
import enlightenment.bsdf.Scattering;
import enlightenment.emitter.LightSample;
import enlightenment.emitter.LightSampler;
import enlightenment.emitter.SampledLight;
import enlightenment.primitive.Hit;
import enlightenment.primitive.Ray;
import enlightenment.sampling.Sampler;
import enlightenment.transport.ray.Optics;
import enlightenment.transport.ray.PathFollower;
import enlightenment.transport.state.GatheredLight;
import enlightenment.transport.state.IncidentLight;
import enlightenment.transport.state.PathEvent;
import enlightenment.transport.state.PathState;
import enlightenment.transport.state.PathStrategy;
import enlightenment.transport.state.PathValue;
import enlightenment.transport.state.PathVertex;
import enlightenment.transport.state.PowerHeuristic;
import enlightenment.world.CompiledScene;
import enlightenment.world.PhysicalScene;
import enlightenment.world.light.LightCone;
import enlightenment.world.light.PhysicalLight;
import enlightenment.world.parts.RayCounters;

/**
 * Next-event estimation: direct light of lamps and surroundings at each vertex, and the MIS weight of emission that BSDF samples hit.
 *
 * <p>At a matte vertex irradiance has closed forms. That of a ball is used everywhere, times a sampled visibility; that of a polygon only
 * where nothing can occlude it, which is a function of light and vertex alone ({@link MatteIrradiance#isClosed}), so that both strategies
 * agree on it. Textured lights have none. All else is sampled, with the power heuristic (E. Veach and L. Guibas, "Optimally combining
 * sampling techniques", 1995).
 */
public final class NextEventEstimation implements PathStrategy {
    /** At the first vertex all lights are sampled if there are at most this many; else one, by the light sampler. */
    private static final int ALL_AT_FIRST = 4;

    private final PhysicalScene physical;
    private final PhysicalLight[] lights;
    private final LightSampler picker;
    private final RayCounters counters;
    private final PathFollower path;
    private final ShadowRays shadow;
    private final MatteIrradiance matte;
    private final Hit hit;
    private final LightView view = new LightView();
    private final LightCone cone = view.cone;
    private final LightSample sample = view.sample;
    private final SampledLight choice = new SampledLight();
    private final double[] pair = new double[2];

    private final LitVertex lit = new LitVertex();

    /** The id of that vertex's primitive; -1 in a medium. */
    private int vertexId;

    /** Whether that vertex is Lambertian. */
    private boolean isMatte;

    /** Whether that vertex sampled all lights, rather than one. */
    private boolean tookAll;

    /** Equiangular sampling along the flight that ended at that vertex, in a medium; null at surfaces. */
    private FlightLight along;

    /** The tint of transmitted light, at a rough interface; null elsewhere. */
    private double[] through;

    /** Whether small lights are left out at that vertex, as the caustic pass covers them. */
    private boolean leavesSmall;

    /** Direct light, as radiance towards the path's previous vertex; of a Lambertian surface as if it were white. */
    public final GatheredLight gathered;

    /** Estimates light of an environment map or a sky; null if the scene has none. */
    private final InfiniteLight infinite;

    public NextEventEstimation(CompiledScene scene, RayCounters counters, PathFollower path) {
        infinite = InfiniteLight.of(scene, counters, path);
        physical = scene.physical;
        gathered = new GatheredLight(physical.hasUltraviolet);
        lights = physical.lights;
        picker = physical.picker;
        this.counters = counters;
        this.path = path;
        hit = path.at.hit;
        shadow = new ShadowRays(scene, counters, path, cone);
        matte = new MatteIrradiance(counters, shadow, view, lit);
    }

    /** Whether a vertex, the path's first or a later one, samples all lights of this number, rather than one. */
    static boolean takesAll(int lights, boolean isFirst) {
        return lights <= 1 || isFirst && lights <= ALL_AT_FIRST;
    }

    private void begin(boolean atMatte, boolean isFirst) {
        isMatte = atMatte;
        leavesSmall = false;
        tookAll = takesAll(lights.length, isFirst);
        along = null;
        vertexId = path.at.id;
        lit.set(path);
        gathered.clear();
        shadow.begin();
    }

    @Override
    public void direct(PathVertex vertex, PathState state, Sampler sampler, PathValue value) {
        if (vertex.isMatte()) {
            gatherMatte(sampler, state.address, !state.hasScattered());
            value.addReflected(gathered, vertex.color);
            return;
        }
        direct(vertex, null, state, sampler, value);
    }

    /**
     * As {@link #direct(PathVertex, PathState, Sampler, PathValue)}, for a vertex that is not Lambertian.
     *
     * @param flight equiangular sampling along the flight that ended at the vertex, in a medium; null elsewhere
     */
    public void direct(PathVertex vertex, FlightLight flight, PathState state, Sampler sampler, PathValue value) {
        boolean isFirst = !state.hasScattered();
        begin(false, isFirst);
        along = flight;
        leavesSmall = vertex.leavesSmallLights;
        if (vertex.event == PathEvent.ROUGH_INTERFACE) {
            lit.openToAllSides();
            through = vertex.color;
        }
        gatherAll(vertex.bsdf, vertex.s, sampler, state.address, isFirst);
        through = null;
        value.add(gathered);
    }

    /**
     * Estimates direct light at the current Lambertian surface.
     *
     * @param isFirst whether the path came here from the eye by delta events only
     */
    private void gatherMatte(Sampler sampler, int address, boolean isFirst) {
        begin(true, isFirst);
        if (tookAll) {
            for (int i = 0; i < lights.length; i++) {
                addMatte(i, 1, sampler, address);
            }
        } else if (choose(sampler, address)) {
            addMatte(choice.light, choice.probability, sampler, address);
        }
        if (infinite != null) {
            infinite.gatherMatte(sampler, address, isFirst);
            gathered.add(infinite.red, infinite.green, infinite.blue);
        }
    }

    /** Whether the surroundings' radiance is the same in all directions. */
    public boolean hasConstantEnvironment() {
        return infinite == null;
    }

    /**
     * Sets {@link #gathered} to the surroundings' radiance along a ray that leaves the scene, times its MIS weight.
     *
     * @param countsSuns whether the disks of suns count if direct light was not sampled at the last vertex
     */
    public void escape(Ray ray, PathState state, boolean countsSuns) {
        if (infinite == null) {
            gathered.set(physical.backgroundR, physical.backgroundG, physical.backgroundB);
        } else {
            infinite.arrive(ray, state.hasDirect ? state.pdf : 0, countsSuns);
            gathered.set(infinite.red, infinite.green, infinite.blue);
        }
    }

    private void addMatte(int index, double probability, Sampler sampler, int address) {
        PhysicalLight l = lights[index];
        if (l.isInPlaneWith(path.at.id, hit.face) || l.isBallOf(path.at.id)) {
            return;
        }
        shadow.isFiltered = false;
        counters.lightSamples++;
        double e = matte.of(l, tookAll ? index : -1, probability, sampler, address);
        if (e > 0) {
            double f = e / (Math.PI * probability);
            shadow.add(l, f, f, f, gathered);
            if (!matte.isByChance) {
                gathered.addCertain(l, f);
            }
        }
        gathered.note(matte.isByChance, e > 0);
    }

    private boolean choose(Sampler sampler, int address) {
        sampler.pair(address, Sampler.Purpose.CHOICE, pair);
        picker.choose(lit.x, lit.y, lit.z, lit.nx, lit.ny, lit.nz, pair[0], choice);
        return choice.light >= 0;
    }

    private void gatherAll(Bsdf bsdf, Scattering s, Sampler sampler, int address, boolean isFirst) {
        if (tookAll) {
            for (int i = 0; i < lights.length; i++) {
                add(bsdf, s, i, 1, sampler, address);
            }
        } else if (choose(sampler, address)) {
            add(bsdf, s, choice.light, choice.probability, sampler, address);
        }
        if (infinite != null) {
            infinite.gather(bsdf, s, through, sampler, address, isFirst, leaves(lights.length));
            gathered.add(infinite.red, infinite.green, infinite.blue);
        }
    }

    private void add(Bsdf bsdf, Scattering s, int index, double probability, Sampler sampler, int address) {
        PhysicalLight l = lights[index];
        double density = leaves(index) ? 0 : sample(l, index, sampler, address);
        if (!(density > 0)) {
            return;
        }
        s.ix = sample.dx;
        s.iy = sample.dy;
        s.iz = sample.dz;
        bsdf.evaluate(s);
        if (through != null) {
            shadow.beginAtInterface(Optics.turn(s, through));
        }
        if ((s.valueR > 0 || s.valueG > 0 || s.valueB > 0) && isVisible(l)) {
            double own = probability * density;
            double onTheWay = along == null ? 0 : along.ratio(index) * density;
            double f = PowerHeuristic.weight(l.isPoint ? 0 : s.pdf, onTheWay, own) / own;
            if (through != null && path.glass.wavelength != null) {
                path.glass.wavelength.color(s);
            }
            shadow.add(l, f * s.valueR, f * s.valueG, f * s.valueB, gathered);
        }
    }

    /** Samples a point of a light; returns its density per solid angle, of a point light the squared distance, and 0 if there is none. */
    private double sample(PhysicalLight l, int index, Sampler sampler, int address) {
        if (l.isInPlaneWith(path.at.id, hit.face) || l.isBallOf(path.at.id)) {
            return 0;
        }
        shadow.isFiltered = false;
        counters.lightSamples++;
        if (!l.isPoint) {
            view.draw(tookAll ? index : -1, sampler, address);
        }
        return view.look(l, lit.x, lit.y, lit.z);
    }

    /**
     * Samples one light at the current surface, not the path's first, without the BSDF.
     *
     * @param out receives direction, density and incident radiance
     */
    public void sample(Sampler sampler, int address, IncidentLight out) {
        begin(false, false);
        out.clear();
        if (tookAll ? lights.length == 0 : !choose(sampler, address)) {
            return;
        }
        PhysicalLight l = lights[tookAll ? 0 : choice.light];
        double density = sample(l, 0, sampler, address);
        double cosine = lit.nx * sample.dx + lit.ny * sample.dy + lit.nz * sample.dz;
        if (density > 0 && cosine > 0 && isVisible(l)) {
            shadow.add(l, 1, 1, 1, gathered);
            out.set(sample, tookAll ? density : choice.probability * density, !l.isPoint, gathered);
        }
    }

    /** Whether a light is left to the caustic pass; suns share the index after the last light. */
    private boolean leaves(int light) {
        return leavesSmall && physical.caustics.takesNarrow(light);
    }

    @Override
    public double weightOfHit(PathState state, Ray ray, int light) {
        return state.hasDirect ? PowerHeuristic.weight(density(ray), state.pdf) : 1;
    }

    /**
     * The density per solid angle with which the last vertex would have sampled the hit point: 0 if it is on no light that is sampled
     * there, infinite if the vertex takes all of the light from a closed form.
     */
    public double density(Ray ray) {
        int index = path.at.light;
        if (index < 0 || lights[index].isBallOf(vertexId)) {
            return 0;
        }
        PhysicalLight l = lights[index];
        view.aim(l, lit.x, lit.y, lit.z);
        if (isMatte && matte.isClosed(l)) {
            return Double.POSITIVE_INFINITY;
        }
        double density = view.density(l.form, ray, hit, lit.x, lit.y, lit.z);
        if (!(density > 0)) {
            return 0;
        }
        double probability =
                tookAll ? 1 : picker.probability(index, lit.x, lit.y, lit.z, lit.nx, lit.ny, lit.nz, choice);
        return (along == null ? probability : PowerHeuristic.both(probability, along.ratio(index))) * density;
    }

    private boolean isVisible(PhysicalLight l) {
        return shadow.isVisible(l, sample);
    }
}
