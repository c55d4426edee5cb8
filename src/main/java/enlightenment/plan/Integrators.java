package enlightenment.plan;

import enlightenment.check.Check;
import enlightenment.classic.cluster.ClusterMethod;
import enlightenment.film.FilmTile;
import enlightenment.math.InvalidValueException;
import enlightenment.method.BidirectionalMethod;
import enlightenment.method.Integrator;
import enlightenment.method.LightPaths;
import enlightenment.method.RayTraceMethod;
import enlightenment.method.SplatIntegrator;
import enlightenment.method.TileIntegrator;
import enlightenment.method.cluster.PhysicalClusterMethod;
import enlightenment.method.metropolis.MetropolisMethod;
import enlightenment.sampling.Distribution;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.Method;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Shading;
import enlightenment.world.CompiledScene;
import enlightenment.world.parts.RayCounters;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.BooleanSupplier;

/** Makes integrators. It is the only place that refers to the class behind each method, and to the traits that planning needs. */
public final class Integrators {
    /**
     * With fewer samples per pixel than this, method {@code cluster} is exactly {@code raytrace}: its survey takes 1.27, every
     * pixel takes at least one, and what is left does not buy more than evenly spaced rays do. Measured: from 2.3 on fire and ice
     * to 2.6 on the keyhole, docs/notes/cluster-laboratory.md.
     */
    private static final double FEWEST_OF_CLUSTER = 2.45;

    /** The largest number with three digits that is still too few for a survey. */
    private static final double MOST_WITHOUT_SURVEY = 2.44;

    /** The number of samples that a search for an error begins with, and that follows a picture without a survey. */
    private static final double FIRST_OF_CLUSTER = 4;

    /** Paths of a pass of caustics per camera sample: docs/notes/caustics.md has what more and less of them bring. */
    private static final double CAUSTIC_PATHS = 1.0 / 8;

    /** Paths of the method that finds nearly all light by them, per camera sample. */
    private static final double LIGHT_PATHS = 1;

    /** Camera rays beside them end at the first surface, mostly. */
    private static final double LIGHT_PATH_WEIGHT = 8;

    /**
     * {@link #FEWEST_OF_CLUSTER} for physical light. Its survey predicts little of later bounces, and with few samples the first paths of
     * each pixel are few. Measured: docs/notes/cluster-sampler.md.
     */
    private static final double FEWEST_OF_PHYSICAL_CLUSTER = 8;

    private static final double MOST_WITHOUT_PHYSICAL_SURVEY = 7.99;

    private static final double FIRST_OF_PHYSICAL_CLUSTER = 8;

    /** With fewer samples there would be hardly any independent paths for chains to begin with. */
    private static final double FEWEST_OF_METROPOLIS = 8;

    private static final double MOST_WITHOUT_METROPOLIS = 7.99;

    private Integrators() {}

    /** The traits of the method of a render before there is a scene. If the block side depends on the shading, it is the larger one. */
    public static MethodTraits traits(RenderSettings settings) {
        return traits(settings.method(), settings);
    }

    /** The traits of a method, whatever that of the settings, for a picture of their size. */
    public static MethodTraits traits(Method method, RenderSettings settings) {
        return traits(method, PhysicalClusterMethod.blockSide(settings));
    }

    /** @param blockSide of methods that share paths */
    private static MethodTraits traits(Method method, int blockSide) {
        if (!(method instanceof BuiltInMethod own)) {
            return MethodTraits.ofAnySamples(
                    method, method instanceof IntegratorFactory factory && factory.dividesIntoPasses());
        }
        return switch (own) {
            case RAYTRACE, LIGHT, BIDIRECTIONAL -> MethodTraits.ofAnySamples(method, true);
            case CLUSTER -> ofCluster(FEWEST_OF_CLUSTER, MOST_WITHOUT_SURVEY, FIRST_OF_CLUSTER, blockSide);
            case BIDIRECTIONAL_CLUSTER -> ofPhysicalCluster(own, blockSide);
            case METROPOLIS ->
                new MethodTraits(
                        false,
                        true,
                        own.standIn().orElseThrow(),
                        FEWEST_OF_METROPOLIS,
                        MOST_WITHOUT_METROPOLIS,
                        FEWEST_OF_METROPOLIS,
                        BuiltInMethod.MetropolisSettings.BLOCK_SIDE);
        };
    }

    /** The fewest samples per pixel with which a method is used itself. */
    public static double fewestSamples(Method method, Shading.Model shading) {
        return traits(method, shading == Shading.Model.PHYSICAL, FilmTile.BLOCK_SIDE)
                .fewest();
    }

    /** The traits of a method for scenes with physical or with classic shading, which differ for {@code cluster} only. */
    static MethodTraits traits(Method method, RenderSettings settings, boolean isPhysical) {
        return traits(method, isPhysical, PhysicalClusterMethod.blockSide(settings));
    }

    private static MethodTraits traits(Method method, boolean isPhysical, int blockSide) {
        if (method != BuiltInMethod.CLUSTER) {
            return traits(method, blockSide);
        }
        return isPhysical
                ? ofPhysicalCluster(BuiltInMethod.CLUSTER, blockSide)
                : ofCluster(FEWEST_OF_CLUSTER, MOST_WITHOUT_SURVEY, FIRST_OF_CLUSTER, FilmTile.BLOCK_SIDE);
    }

    private static MethodTraits ofPhysicalCluster(BuiltInMethod method, int blockSide) {
        return new MethodTraits(
                false,
                false,
                method.standIn().orElseThrow(),
                FEWEST_OF_PHYSICAL_CLUSTER,
                MOST_WITHOUT_PHYSICAL_SURVEY,
                FIRST_OF_PHYSICAL_CLUSTER,
                blockSide);
    }

    private static MethodTraits ofCluster(double fewest, double mostBelow, double first, int blockSide) {
        Method below = BuiltInMethod.CLUSTER.standIn().orElseThrow();
        return new MethodTraits(false, false, below, fewest, mostBelow, first, blockSide);
    }

    /** Whether a method can report its camera samples one by one. */
    public static boolean recordsSamples(Method method) {
        return method == BuiltInMethod.RAYTRACE;
    }

    /** Whether level 0 of a method means exactly antialias² samples in each pixel. */
    static boolean hasLevelOfAntialias(Method method) {
        return method == BuiltInMethod.RAYTRACE;
    }

    /** The function from the number of samples to the level of a method. */
    static Levels levels(Method method, CompiledScene scene, RenderSettings settings, BooleanSupplier cancelled) {
        boolean reusesLight = method == BuiltInMethod.BIDIRECTIONAL_CLUSTER;
        return reusesLight || method == BuiltInMethod.CLUSTER
                ? new EffortLevels(scene, settings, reusesLight, cancelled)
                : Levels.SAMPLES;
    }

    /** Whether a method adds paths that may end anywhere to the tiles of any scene. */
    public static boolean alwaysHasLightPaths(Method method) {
        return method == BuiltInMethod.LIGHT || method == BuiltInMethod.BIDIRECTIONAL;
    }

    /** Whether paths that may end anywhere are added to the tiles of a method. */
    public static boolean hasLightPaths(Method method, CompiledScene scene, RenderSettings settings) {
        return lightPathsPerSample(method, scene, settings) > 0;
    }

    /**
     * The number of light paths splatted over a method's tiles, per camera sample of the whole picture. 0 for none, as of a method that has
     * no tiles.
     */
    static double lightPathsPerSample(Method method, CompiledScene scene, RenderSettings settings) {
        if (method instanceof BuiltInMethod own) {
            return switch (own) {
                case RAYTRACE, CLUSTER, BIDIRECTIONAL_CLUSTER, METROPOLIS -> scene.hasCausticPass() ? CAUSTIC_PATHS : 0;
                case LIGHT -> LIGHT_PATHS;
                case BIDIRECTIONAL -> BidirectionalMethod.PATHS_PER_SAMPLE;
            };
        }
        return method instanceof IntegratorFactory factory && method.kind() == Method.Kind.TILES
                ? factory.lightPathsPerSample(scene, settings)
                : 0;
    }

    /** The approximate cost of a light path splatted over a method's tiles, in camera samples of these; for progress. */
    public static double weightOfLightPath(Method method) {
        return method == BuiltInMethod.LIGHT ? LIGHT_PATH_WEIGHT : 1;
    }

    /**
     * The integrator of a plan's splatted paths, for one thread. These are all paths of a method without tiles, otherwise the plan's light
     * paths.
     *
     * @param counters are added to by it
     */
    public static SplatIntegrator splats(
            RenderPlan plan, CompiledScene scene, RenderSettings settings, RayCounters counters) {
        if (traits(plan.method(), settings).areBatches()) {
            return (SplatIntegrator) of(plan, scene, settings, counters);
        }
        if (plan.method() instanceof IntegratorFactory factory) {
            return factory.makeLightPaths(plan, scene, settings, counters);
        }
        Check.that(scene.physical != null, "plan", "has light paths, which no scene of classic shading has");
        return switch ((BuiltInMethod) plan.method()) {
            case RAYTRACE, CLUSTER, BIDIRECTIONAL_CLUSTER, METROPOLIS ->
                LightPaths.ofCaustics(scene, settings, counters);
            case LIGHT -> LightPaths.ofAllLight(scene, settings, counters);
            case BIDIRECTIONAL -> LightPaths.ofBidirectional(scene, settings, counters);
        };
    }

    /** The light transport of a scene that a method cannot sample, in plain words; empty without such. */
    public static Optional<String> blindSpot(Method method, CompiledScene scene) {
        if (method != BuiltInMethod.LIGHT
                || scene.physical == null
                || !scene.isEver(moment -> moment.physical.showsMirrored)) {
            return Optional.empty();
        }
        return Optional.of(method.word()
                + " cannot see surfaces in mirrors and smooth coats, in panes or through glass that bends light:"
                + " only what glows shows there; " + Method.RAYTRACE.word() + " sees them");
    }

    /** Whether a method renders this scene otherwise than all others: light paths cannot be shared in every scene. */
    static boolean differs(Method method, CompiledScene scene) {
        return method != BuiltInMethod.BIDIRECTIONAL_CLUSTER || PhysicalClusterMethod.canReuseLight(scene);
    }

    /** Light that no path of any method finds, as sentences without full stops. */
    public static List<String> limitations(CompiledScene scene) {
        return scene.physical != null && scene.isEver(Integrators::mirrorsPoints)
                ? List.of(
                        "what mirrors, smooth coats, panes and smooth glass make of the light of points is not seen where the eye"
                                + " sees it in such things: no path finds it; a small sphere in place of the point is seen")
                : List.of();
    }

    /**
     * Why the error of a picture by a method may be underestimated whatever its samples show, each as the end of a sentence; empty if no
     * reason is known.
     */
    public static List<String> undersampled(Method method, CompiledScene scene) {
        return UndersampledLight.of(method, scene);
    }

    private static boolean mirrorsPoints(CompiledScene moment) {
        return moment.physical.showsMirrored
                && moment.physical.hasCausticPass()
                && Arrays.stream(moment.physical.lights).anyMatch(light -> light.isPoint);
    }

    /** The settings of the cheapest pictures that resemble those of some settings: for previews. */
    public static RenderSettings cheapest(RenderSettings settings) {
        Method below = traits(settings).below();
        return below == BuiltInMethod.RAYTRACE
                ? settings.using(new BuiltInMethod.RayTraceSettings(1))
                : settings.withMethod(below);
    }

    /** The integrator of the planned method, for one thread. */
    public static Integrator of(RenderPlan plan, CompiledScene scene, RenderSettings settings, RayCounters counters) {
        return of(plan, scene, settings, counters, Learned.UNSEEN);
    }

    /**
     * The integrator of the planned method, for one thread, with listeners.
     *
     * @param counters are added to by it
     * @param learned the listeners for what the method learns
     * @throws InvalidValueException for a method without an integrator
     */
    public static Integrator of(
            RenderPlan plan, CompiledScene scene, RenderSettings settings, RayCounters counters, Learned learned) {
        if (!(plan.method() instanceof BuiltInMethod method)) {
            return ofExtension(plan, scene, settings, counters);
        }
        return switch (method) {
            case RAYTRACE ->
                learned.samples() == null
                        ? RayTraceMethod.of(scene, settings, counters, plan.level())
                        : RayTraceMethod.recorded(scene, settings, counters, plan.level(), learned.samples());
            case LIGHT -> RayTraceMethod.ofSeenLight(scene, settings, counters, plan.level());
            case BIDIRECTIONAL -> BidirectionalMethod.of(scene, settings, counters, plan.level());
            case CLUSTER ->
                scene.physical == null
                        ? new ClusterMethod(
                                scene,
                                settings,
                                counters,
                                Distribution.of(BuiltInMethod.ClusterSettings.of(settings)
                                        .proposal()),
                                plan.level(),
                                plan.samples(),
                                learned.clusters())
                        : new PhysicalClusterMethod(scene, settings, counters, plan.level(), plan.samples(), false);
            case BIDIRECTIONAL_CLUSTER ->
                new PhysicalClusterMethod(scene, settings, counters, plan.level(), plan.samples(), true);
            case METROPOLIS -> new MetropolisMethod(scene, settings, counters, plan.level(), learned.chains());
        };
    }

    private static Integrator ofExtension(
            RenderPlan plan, CompiledScene scene, RenderSettings settings, RayCounters counters) {
        String word = plan.method().word();
        if (!(plan.method() instanceof IntegratorFactory factory)) {
            throw new InvalidValueException("method", "has no class behind it that renders: " + word);
        }
        Integrator integrator = factory.make(plan, scene, settings, counters);
        boolean divides = integrator instanceof TileIntegrator tiles && tiles.dividesIntoPasses();
        MethodTraits traits = traits(plan.method(), settings);
        if (integrator instanceof SplatIntegrator != traits.areBatches() || divides != traits.dividesIntoPasses()) {
            throw new IllegalStateException("the method " + word + " is not what it says: " + integrator.getClass());
        }
        return integrator;
    }
}
