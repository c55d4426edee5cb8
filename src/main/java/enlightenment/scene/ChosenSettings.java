package enlightenment.scene;

import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/**
 * Values that were chosen for settings of rendering methods, and for those that all methods have in common. A scene may choose for one method and
 * the command line take another, or compare several. What is not chosen has its default, and to choose the default is to choose nothing: so two of
 * these are equal if every method renders the same with both. Immutable.
 */
public final class ChosenSettings {
    /** Every setting has its default. */
    public static final ChosenSettings NONE = new ChosenSettings(Map.of());

    private final Map<String, Object> values;

    private ChosenSettings(Map<String, Object> values) {
        this.values = values;
    }

    /** The settings of one method; all others have their defaults. */
    public static ChosenSettings of(Method.Settings settings) {
        return NONE.with(settings);
    }

    /** The value of a setting: what was chosen, or the default. */
    public Object value(Method.Setting setting) {
        return values.getOrDefault(setting.key(), setting.usual());
    }

    /**
     * The value of a whole number.
     *
     * @throws ArithmeticException if it is none of 32 bits
     */
    public int whole(Method.Setting.Whole setting) {
        return Math.toIntExact(setting.checked(value(setting)));
    }

    /** The value of a word. */
    public String word(Method.Setting.Word setting) {
        return setting.checked(value(setting));
    }

    /** The values that are not defaults, by the keys of their settings: whole numbers are Long, words are String. */
    public Map<String, Object> values() {
        return values;
    }

    /**
     * These values with another value of a setting.
     *
     * @throws enlightenment.math.InvalidValueException (key {@link Method.Setting#key}) if it may not have it
     */
    public ChosenSettings with(Method.Setting setting, Object value) {
        Object checked = setting.checked(value);
        TreeMap<String, Object> changed = new TreeMap<>(values);
        if (checked.equals(setting.usual())) {
            changed.remove(setting.key());
        } else {
            changed.put(setting.key(), checked);
        }
        return new ChosenSettings(Collections.unmodifiableMap(changed));
    }

    /** These values with those of all settings of one method. */
    public ChosenSettings with(Method.Settings settings) {
        ChosenSettings changed = this;
        for (Method.Setting setting : settings.method().settings()) {
            changed = changed.with(setting, settings.value(setting));
        }
        return changed;
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof ChosenSettings o && values.equals(o.values);
    }

    @Override
    public int hashCode() {
        return values.hashCode();
    }

    /** Keys and values, as maps show them. */
    @Override
    public String toString() {
        return values.toString();
    }

    /**
     * The settings that all methods have in common, beside the number of positions per pixel; pictures depend on each. Scene files,
     * their schema, the command line, reports, protocols and the identity of a picture take them from here.
     *
     * <p>All methods may be called by several threads at once.
     */
    public static final class Common {
        /** {@link RenderSettings#seed}. */
        public static final Method.Setting.Whole SEED =
                new Method.Setting.Whole("seed", Long.MIN_VALUE, Long.MAX_VALUE, 0, "seed of the random numbers");

        /** All common settings, in the order of help and reports. */
        public static final List<Method.Setting> ALL = List.of(SEED);

        private Common() {}

        /** Whether a common setting has this key: then no method's own may. */
        static boolean has(String key) {
            return ALL.stream().anyMatch(setting -> setting.key().equals(key));
        }
    }
}
