package enlightenment.scene;

import enlightenment.sampling.Distribution;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/** The rendering methods of this program, and the settings of their own. This is the one place that has their names. */
public enum BuiltInMethod implements Method {
    /** {@link Method#RAYTRACE}. */
    RAYTRACE(
            "raytrace",
            "evenly spaced camera rays, the same number of light samples at every hit",
            List.of(RayTraceSettings.SHADOW_SAMPLES),
            null,
            Shading.Model.values()),

    /** {@link Method#CLUSTER}. */
    CLUSTER(
            "cluster",
            "a survey of the picture allots camera rays and light samples, and ray clusters propose light points",
            List.of(ClusterSettings.PROPOSAL),
            RAYTRACE,
            Shading.Model.values()),

    /** Paths from the lights: the paper's other direction. */
    LIGHT(
            "light",
            "paths from the lights, connected to the eye wherever they are scattered",
            List.of(),
            null,
            Shading.Model.PHYSICAL),

    /** Paths from both ends: for light that is hard to find from the eye. */
    BIDIRECTIONAL(
            "bidirectional",
            "paths from the eye and from lights, each vertex of one connected to each of the other",
            List.of(),
            null,
            Shading.Model.PHYSICAL),

    /** Paths from both ends, shared among pixels: for light that is hard to find from the eye. */
    BIDIRECTIONAL_CLUSTER(
            "bidirectional-cluster",
            "paths from the eye and from lights, whose vertices neighbouring pixels share",
            List.of(),
            RAYTRACE,
            Shading.Model.PHYSICAL),

    /** {@link Method#METROPOLIS}. */
    METROPOLIS(
            "metropolis",
            "Markov chains in blocks of the picture: paths that found light propose others near them",
            List.of(MetropolisSettings.LARGE_STEPS, MetropolisSettings.MUTATIONS),
            RAYTRACE,
            Shading.Model.values());

    /** All built-in methods, in order. */
    public static final List<Method> ALL = List.of(values());

    private final String word;
    private final String description;
    private final List<Method.Setting> settings;
    private final Method standIn;
    private final Set<Shading.Model> shadings;

    BuiltInMethod(
            String word, String description, List<Method.Setting> settings, Method standIn, Shading.Model... shadings) {
        this.word = word;
        this.description = description;
        this.settings = settings;
        this.standIn = standIn;
        this.shadings = Set.of(shadings);
    }

    /** The built-in methods that can render scenes of a shading, in order. */
    public static List<BuiltInMethod> rendering(Shading.Model model) {
        List<BuiltInMethod> able = new ArrayList<>();
        for (BuiltInMethod method : values()) {
            if (method.shadings.contains(model)) {
                able.add(method);
            }
        }
        return List.copyOf(able);
    }

    @Override
    public String word() {
        return word;
    }

    @Override
    public String description() {
        return description;
    }

    @Override
    public Kind kind() {
        return Kind.TILES;
    }

    @Override
    public Set<Shading.Model> shadings() {
        return shadings;
    }

    @Override
    public boolean canRender(Shading.LightFeature feature) {
        return this != CLUSTER || feature != Shading.LightFeature.CLASSIC_MOTION;
    }

    @Override
    public List<Method.Setting> settings() {
        return settings;
    }

    @Override
    public Optional<Method> standIn() {
        return Optional.ofNullable(standIn);
    }

    @Override
    public boolean hasClusters() {
        return this == CLUSTER;
    }

    /** The {@link #word}. */
    @Override
    public String toString() {
        return word;
    }

    /**
     * The settings of {@link Method#RAYTRACE}.
     *
     * @param shadowSamples light samples per hit and light, 1..1,000,000
     */
    public record RayTraceSettings(int shadowSamples) implements Method.Settings {
        /** {@link #shadowSamples}, 10 unless chosen. Methods that do not have it choose their number. */
        public static final Method.Setting.Whole SHADOW_SAMPLES =
                new Method.Setting.Whole("shadowSamples", 1, 1_000_000, 10, "light samples per hit and light");

        /**
         * Checks the range.
         *
         * @throws enlightenment.math.InvalidValueException (key {@code shadowSamples}) if the number is out of it
         */
        public RayTraceSettings {
            SHADOW_SAMPLES.checked(shadowSamples);
        }

        /** The values in render settings. */
        public static RayTraceSettings of(RenderSettings settings) {
            return new RayTraceSettings(settings.chosen().whole(SHADOW_SAMPLES));
        }

        @Override
        public Method method() {
            return Method.RAYTRACE;
        }

        @Override
        public Object value(Method.Setting setting) {
            return shadowSamples;
        }
    }

    /**
     * The settings of {@link Method#CLUSTER}.
     *
     * @param proposal the family of distributions that ray clusters propose light points from: {@code "normal"}, {@code "zeta"} or
     *     {@code "linear"}
     */
    public record ClusterSettings(String proposal) implements Method.Settings {
        /** {@link #proposal}, {@code "normal"} unless chosen. */
        public static final Method.Setting.Word PROPOSAL = new Method.Setting.Word(
                "proposal", Distribution.NAMES, "distribution that ray clusters propose light samples from");

        /**
         * Checks the name.
         *
         * @throws enlightenment.math.InvalidValueException (key {@code proposal}) if there is no such family
         */
        public ClusterSettings {
            PROPOSAL.checked(proposal);
        }

        /** The values in render settings. */
        public static ClusterSettings of(RenderSettings settings) {
            return new ClusterSettings(settings.chosen().word(PROPOSAL));
        }

        @Override
        public Method method() {
            return Method.CLUSTER;
        }

        @Override
        public Object value(Method.Setting setting) {
            return proposal;
        }
    }

    /**
     * The settings of {@link Method#METROPOLIS}.
     *
     * @param largeSteps how many of a hundred proposals of a chain are new paths altogether, 1..100
     * @param mutations proposals of each chain, 1..1,000,000
     */
    public record MetropolisSettings(int largeSteps, int mutations) implements Method.Settings {
        /** Side, in pixels, of the blocks of the picture that chains live in. */
        public static final int BLOCK_SIDE = 64;

        /** {@link #largeSteps}. */
        public static final Method.Setting.Whole LARGE_STEPS =
                new Method.Setting.Whole("largeSteps", 1, 100, 5, "new paths among a hundred proposals of a chain");

        /** {@link #mutations}. */
        public static final Method.Setting.Whole MUTATIONS =
                new Method.Setting.Whole("mutations", 1, 1_000_000, 250, "proposals of a chain");

        /**
         * Checks the ranges.
         *
         * @throws enlightenment.math.InvalidValueException (key {@code largeSteps} or {@code mutations}) if a number is out of its own
         */
        public MetropolisSettings {
            LARGE_STEPS.checked(largeSteps);
            MUTATIONS.checked(mutations);
        }

        /** The values in render settings. */
        public static MetropolisSettings of(RenderSettings settings) {
            ChosenSettings chosen = settings.chosen();
            return new MetropolisSettings(chosen.whole(LARGE_STEPS), chosen.whole(MUTATIONS));
        }

        /** The number of blocks of a render: those of the whole picture with pixels of the rendered part. */
        public static long blocks(RenderSettings settings) {
            RenderSettings.Crop c = settings.region();
            long across = (c.x() + c.width() - 1) / BLOCK_SIDE - c.x() / BLOCK_SIDE + 1;
            long down = (c.y() + c.height() - 1) / BLOCK_SIDE - c.y() / BLOCK_SIDE + 1;
            return across * down;
        }

        @Override
        public Method method() {
            return Method.METROPOLIS;
        }

        @Override
        public Object value(Method.Setting setting) {
            return setting == LARGE_STEPS ? largeSteps : mutations;
        }
    }
}
