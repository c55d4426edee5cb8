package enlightenment.scene;

import enlightenment.math.InvalidValueException;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/**
 * A method of rendering: which samples are taken, and how they become pixels. This says what a method is called, what it can
 * do and what there is to choose; the class that does it lies elsewhere. Scene files, their schema, the command line, reports,
 * protocols and measurements ask here, so that a method that is added is known to all of them. Two methods are equal only if
 * they are the same object.
 *
 * <p>The methods of this program are {@link BuiltInMethod}; others are found as services, see {@link MethodExtension}. They are
 * looked for only where a word is none of ours, or where all methods are listed: what needs none of them does not pay for it.
 */
// No default methods: an interface that has some is initialised before the classes that implement it, and these
// constants
// would be null to whoever meets the enum first.
public sealed interface Method permits BuiltInMethod, AutomaticMethod, MethodExtension {
    /** Evenly spaced camera rays, the same number of light samples at every hit. */
    Method RAYTRACE = BuiltInMethod.RAYTRACE;

    /** The paper's ray clusters: a survey allots samples to pixels and learns which light points to propose. */
    Method CLUSTER = BuiltInMethod.CLUSTER;

    /** Markov chains in blocks of the picture, by the algorithm of Metropolis and Hastings. */
    Method METROPOLIS = BuiltInMethod.METROPOLIS;

    /** The program chooses: one of {@link BuiltInMethod} takes its place before anything is rendered. Not among {@link #all}. */
    Method AUTO = AutomaticMethod.AUTO;

    /** What a unit of a method's work is. */
    enum Kind {
        /** The pixels of one tile: units write disjoint parts of the picture. */
        TILES,

        /** Paths that may end anywhere: units add to the whole picture. */
        SPLATS
    }

    /** The name in scene files, on the command line and in reports: letters, digits and hyphens. */
    String word();

    /** What it does, in one line without a full stop. */
    String description();

    /** What a unit of its work is. */
    Kind kind();

    /** What it can render; at least one. */
    Set<Shading.Model> shadings();

    /** Whether it can render scenes of physical shading that ask for this. */
    boolean canRender(LightFeature feature);

    /** Its settings, each with its key, its range and its default, in the order in which they are told. */
    List<MethodSetting> settings();

    /** What makes the samples in its place where there are too few of them for its survey; empty if none are too few. */
    Optional<Method> standIn();

    /** Whether it learns ray clusters that can be told of. */
    boolean hasClusters();

    /** All methods that render: our own in order, then those from outside by their words. */
    static List<Method> all() {
        List<Method> all = new ArrayList<>(BuiltInMethod.ALL);
        all.addAll(Extensions.found());
        return List.copyOf(all);
    }

    /** What a method can be set to: {@link #all}, and behind them {@link #AUTO}. */
    static List<Method> selectable() {
        return selectable(all());
    }

    /** These methods and {@link #AUTO}. */
    static List<Method> selectable(List<? extends Method> methods) {
        List<Method> all = new ArrayList<>(methods);
        all.add(AUTO);
        return List.copyOf(all);
    }

    /** The names of all methods, in the order of {@link #all}. */
    static List<String> words() {
        return words(all());
    }

    /** The names of these methods. */
    static List<String> words(List<? extends Method> methods) {
        List<String> words = new ArrayList<>();
        for (Method method : methods) {
            words.add(method.word());
        }
        return List.copyOf(words);
    }

    /** The method with this name, {@link #AUTO} included; empty if there is none. */
    static Optional<Method> of(String word) {
        Optional<Method> own = find(selectable(BuiltInMethod.ALL), word);
        return own.isPresent() ? own : find(Extensions.found(), word);
    }

    private static Optional<Method> find(List<Method> methods, String word) {
        for (Method method : methods) {
            if (method.word().equals(word)) {
                return Optional.of(method);
            }
        }
        return Optional.empty();
    }

    /**
     * The method with this name.
     *
     * @throws enlightenment.math.InvalidValueException if there is none
     */
    static Method named(String word) {
        Optional<Method> method = of(word);
        if (method.isEmpty()) {
            throw new InvalidValueException(
                    "method", "must be one of " + words(selectable()) + ", not \"" + word + "\"");
        }
        return method.get();
    }

    /** The settings of these methods, each once although several may have it, in order; then those that all have in common. */
    static List<MethodSetting> settings(List<? extends Method> methods) {
        List<MethodSetting> settings = new ArrayList<>(own(methods));
        settings.addAll(CommonSettings.ALL);
        return List.copyOf(settings);
    }

    private static List<MethodSetting> own(List<? extends Method> methods) {
        // By key, which settles it: to compare records takes a hundred classes more to start.
        Map<String, MethodSetting> settings = new LinkedHashMap<>();
        for (Method method : methods) {
            for (MethodSetting setting : method.settings()) {
                settings.putIfAbsent(setting.key(), setting);
            }
        }
        return List.copyOf(settings.values());
    }

    /**
     * The settings that have an influence on a method's pictures, beside those that all have in common: its own, and those of what
     * stands in for it where samples are few.
     */
    static List<MethodSetting> influences(Method method) {
        Optional<Method> standIn = method.standIn();
        return own(standIn.isPresent() ? List.of(method, standIn.get()) : List.of(method));
    }

    /** Whether a method can render a scene, all of what it asks for. */
    static boolean supports(Method method, Scene scene) {
        return method.shadings().contains(scene.shading().model())
                && LightFeature.of(scene).keySet().stream().allMatch(method::canRender);
    }

    /**
     * Fails unless a method can render a scene.
     *
     * @throws SceneException that names the place, the method and what it can render
     */
    static void requireSupport(Method method, Scene scene) {
        Shading.Model model = scene.shading().model();
        if (!method.shadings().contains(model)) {
            throw SceneException.of(
                    "/shading/model",
                    "the method " + method.word() + " cannot render " + model.word() + " shading, only "
                            + Shading.Model.words(method.shadings()) + "; "
                            + able(words(all().stream()
                                    .filter(m -> m.shadings().contains(model))
                                    .toList())));
        }
        Map<LightFeature, String> asked = LightFeature.of(scene);
        for (Map.Entry<LightFeature, String> entry : asked.entrySet()) {
            if (!method.canRender(entry.getKey())) {
                throw SceneException.of(
                        entry.getValue(),
                        "the method " + method.word() + " cannot render "
                                + entry.getKey().description() + "; "
                                + able(words(all().stream()
                                        .filter(m -> asked.keySet().stream().allMatch(m::canRender))
                                        .toList())));
            }
        }
    }

    private static String able(List<String> words) {
        return words.isEmpty() ? "no method can yet" : "what can: " + String.join(", ", words);
    }
}
