package enlightenment.scene;

import enlightenment.check.Check;
import enlightenment.math.InvalidValueException;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;

/**
 * A method of rendering: which samples are taken, and how they become pixels. It has the method's name, abilities and settings; the class
 * that renders lies elsewhere. Scene files, their schema, the command line, reports, protocols and measurements use it, so that all of them
 * support a method that is added. Two methods are equal only if they are the same object.
 *
 * <p>The methods of this program are {@link BuiltInMethod}; others are found as services, see {@link MethodExtension}. The services are
 * searched only where a word is none of ours, or where all methods are listed.
 */
// No default methods: an interface that has some is initialised before the classes that implement it, and these
// constants would be null for code that uses the enum first.
public sealed interface Method permits BuiltInMethod, AutomaticMethod, MethodExtension {
    /** Evenly spaced camera rays, the same number of light samples at every hit. */
    Method RAYTRACE = BuiltInMethod.RAYTRACE;

    /** The paper's ray clusters: a survey allots samples to pixels and learns which light points to propose. */
    Method CLUSTER = BuiltInMethod.CLUSTER;

    /** Markov chains in blocks of the picture, by the algorithm of Metropolis and Hastings. */
    Method METROPOLIS = BuiltInMethod.METROPOLIS;

    /** The program chooses: one of {@link BuiltInMethod} takes its place before anything is rendered. Not among {@link #all}. */
    Method AUTO = AutomaticMethod.AUTO;

    /** The kinds of a method's units of work. */
    enum Kind {
        /** The pixels of one tile: units write disjoint parts of the picture. */
        TILES,

        /** Paths that may end anywhere: units add to the whole picture. */
        SPLATS
    }

    /** The name in scene files, on the command line and in reports: letters, digits and hyphens. */
    String word();

    /** Its description, in one line without a full stop. */
    String description();

    /** The kind of its units of work. */
    Kind kind();

    /** The shadings that it can render; at least one. */
    Set<Shading.Model> shadings();

    /** Whether it can render scenes of physical shading that need this feature. */
    boolean canRender(Shading.LightFeature feature);

    /** Its settings, each with its key, its range and its default, in the order of lists and reports. */
    List<Setting> settings();

    /** What makes the samples in its place where there are too few of them for its survey; empty if none are too few. */
    Optional<Method> standIn();

    /** Whether it learns ray clusters that can be returned. */
    boolean hasClusters();

    /** All methods that render: the built-in ones in order, then those from services by their words. */
    static List<Method> all() {
        List<Method> all = new ArrayList<>(BuiltInMethod.ALL);
        all.addAll(Extensions.found());
        return List.copyOf(all);
    }

    /** The methods that can be selected: {@link #all}, and behind them {@link #AUTO}. */
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
    static List<Setting> settings(List<? extends Method> methods) {
        List<Setting> settings = new ArrayList<>(own(methods));
        settings.addAll(ChosenSettings.Common.ALL);
        return List.copyOf(settings);
    }

    private static List<Setting> own(List<? extends Method> methods) {
        // By key, which settles it: to compare records takes a hundred classes more to start.
        Map<String, Setting> settings = new LinkedHashMap<>();
        for (Method method : methods) {
            for (Setting setting : method.settings()) {
                settings.putIfAbsent(setting.key(), setting);
            }
        }
        return List.copyOf(settings.values());
    }

    /**
     * The settings that have an influence on a method's pictures, beside those that all have in common: its own, and those of what
     * stands in for it where samples are few.
     */
    static List<Setting> influences(Method method) {
        Optional<Method> standIn = method.standIn();
        return own(standIn.isPresent() ? List.of(method, standIn.get()) : List.of(method));
    }

    /** Whether a method can render a scene, all of what it asks for. */
    static boolean supports(Method method, Scene scene) {
        return method.shadings().contains(scene.shading().model())
                && Shading.LightFeature.of(scene).keySet().stream().allMatch(method::canRender);
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
        Map<Shading.LightFeature, String> asked = Shading.LightFeature.of(scene);
        for (Map.Entry<Shading.LightFeature, String> entry : asked.entrySet()) {
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

    /**
     * A setting of some methods, or of all ({@link ChosenSettings.Common}): what it is called, and which values it may have. In scene files it
     * is a key of the render part, on the command line an option.
     */
    sealed interface Setting permits Setting.Whole, Setting.Word {
        /** The key in scene files and reports: letters and digits, a small letter first. It must be none of the render part's own. */
        String key();

        /** A description in some words without a full stop; ranges and defaults stand beside it. */
        String description();

        /** The value where none is chosen. */
        Object usual();

        /**
         * A value that it may have, as {@link ChosenSettings#values} has it.
         *
         * @throws enlightenment.math.InvalidValueException (key {@link #key}) if it may not
         */
        Object checked(Object value);

        /** The values that it may have, for people. */
        String range();

        /** The option on the command line: {@code --shadow-samples} for the key {@code shadowSamples}. */
        default String option() {
            return "--" + key().replaceAll("([A-Z])", "-$1").toLowerCase(Locale.ROOT);
        }

        private static void checkKey(String key, String description) {
            Objects.requireNonNull(description, "description");
            if (!key.matches("[a-z][A-Za-z0-9]*")
                    || List.of("method", "antialias").contains(key)) {
                throw new IllegalArgumentException(
                        "a setting needs a key of letters and digits of its own, not \"" + key + "\"");
            }
        }

        /**
         * A whole number.
         *
         * @param key as {@link Setting#key}
         * @param min the least value
         * @param max the greatest value
         * @param usualValue the value where none is chosen
         * @param description as {@link Setting#description}
         */
        record Whole(String key, long min, long max, long usualValue, String description) implements Setting {
            /** Checks that the default lies in the range. */
            public Whole {
                checkKey(key, description);
                if (usualValue < min || usualValue > max) {
                    throw new IllegalArgumentException(usualValue + " is outside " + min + ".." + max);
                }
            }

            @Override
            public Long usual() {
                return usualValue;
            }

            @Override
            public Long checked(Object value) {
                boolean isWhole = value instanceof Integer || value instanceof Long;
                long number = isWhole ? ((Number) value).longValue() : 0;
                Check.that(
                        isWhole && number >= min && number <= max, key, "must lie in " + limits() + ", not " + value);
                return number;
            }

            /** {@code min..max}. */
            public String limits() {
                return min + ".." + max;
            }

            /** The {@link #limits}, in words if every number of 64 bits lies in them. */
            @Override
            public String range() {
                return min == Long.MIN_VALUE && max == Long.MAX_VALUE ? "any 64-bit whole number" : limits();
            }
        }

        /**
         * One of some words.
         *
         * @param key as {@link Setting#key}
         * @param words the values, the default first
         * @param description as {@link Setting#description}
         */
        record Word(String key, List<String> words, String description) implements Setting {
            /** Copies the list, which must not be empty. */
            public Word {
                checkKey(key, description);
                words = List.copyOf(words);
                if (words.isEmpty()) {
                    throw new IllegalArgumentException("a setting needs a value");
                }
            }

            @Override
            public String usual() {
                return words.get(0);
            }

            @Override
            public String checked(Object value) {
                Check.that(
                        value instanceof String s && words.contains(s),
                        key,
                        "must be one of " + words + ", not " + value);
                return (String) value;
            }

            /** {@code normal (default), zeta or linear}. */
            @Override
            public String range() {
                StringBuilder text = new StringBuilder(usual()).append(" (default)");
                for (int i = 1; i < words.size(); i++) {
                    text.append(i < words.size() - 1 ? ", " : " or ").append(words.get(i));
                }
                return text.toString();
            }
        }
    }

    /**
     * The settings of one method, as a record of its own: {@link BuiltInMethod.RayTraceSettings}, {@link BuiltInMethod.ClusterSettings}, or one of an extension.
     * What was chosen of the settings of all methods is a {@link ChosenSettings}.
     *
     * <p>Immutable.
     */
    interface Settings {
        /** Whose settings they are. */
        Method method();

        /** The value of one of the {@link Method#settings}, which this must have. */
        Object value(Method.Setting setting);
    }
}
