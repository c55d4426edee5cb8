package enlightenment.scene;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/** The methods of this program. This is the one place that has their names. */
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

    /** {@link Method#METROPOLIS}. */
    METROPOLIS(
            "metropolis",
            "Markov chains in blocks of the picture: paths that found light propose others near them",
            List.of(MetropolisSettings.LARGE_STEPS, MetropolisSettings.MUTATIONS),
            RAYTRACE,
            Shading.Model.values());

    /** All of them, in order. */
    public static final List<Method> ALL = List.of(values());

    private final String word;
    private final String description;
    private final List<MethodSetting> settings;
    private final Method standIn;
    private final Set<Shading.Model> shadings;

    BuiltInMethod(
            String word, String description, List<MethodSetting> settings, Method standIn, Shading.Model... shadings) {
        this.word = word;
        this.description = description;
        this.settings = settings;
        this.standIn = standIn;
        this.shadings = Set.of(shadings);
    }

    /** Those that can render scenes of a shading, in order. */
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
    public boolean canRender(LightFeature feature) {
        return switch (feature) {
            case SCATTERING -> true;
            case FLUORESCENCE -> true;
            case DISPERSION -> true;
            case MOTION -> this == RAYTRACE || this == LIGHT || this == BIDIRECTIONAL;
            case SURROUNDINGS -> true;
        };
    }

    @Override
    public List<MethodSetting> settings() {
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
}
