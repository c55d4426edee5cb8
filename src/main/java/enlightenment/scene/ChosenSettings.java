package enlightenment.scene;

import java.util.Collections;
import java.util.Map;
import java.util.TreeMap;

/**
 * What was chosen of the settings of all methods, whichever is in use, and of the {@link CommonSettings}: a scene may choose for
 * one method and the command line take another, or compare several. What is not chosen has its default, and to choose the default is to
 * choose nothing: so two of these are equal if every method renders the same with both. Immutable.
 */
public final class ChosenSettings {
    /** Every setting has its default. */
    public static final ChosenSettings NONE = new ChosenSettings(Map.of());

    private final Map<String, Object> values;

    private ChosenSettings(Map<String, Object> values) {
        this.values = values;
    }

    /** Those of one method; all others have their defaults. */
    public static ChosenSettings of(MethodSettings settings) {
        return NONE.with(settings);
    }

    /** The value of a setting: what was chosen, or the default. */
    public Object value(MethodSetting setting) {
        return values.getOrDefault(setting.key(), setting.usual());
    }

    /**
     * The value of a whole number.
     *
     * @throws ArithmeticException if it is none of 32 bits
     */
    public int whole(MethodSetting.Whole setting) {
        return Math.toIntExact(setting.checked(value(setting)));
    }

    /** The value of a word. */
    public String word(MethodSetting.Word setting) {
        return setting.checked(value(setting));
    }

    /** The values that are not defaults, by the keys of their settings: whole numbers are Long, words are String. */
    public Map<String, Object> values() {
        return values;
    }

    /**
     * The same with another value of a setting.
     *
     * @throws enlightenment.math.InvalidValueException (key {@link MethodSetting#key}) if it may not have it
     */
    public ChosenSettings with(MethodSetting setting, Object value) {
        Object checked = setting.checked(value);
        TreeMap<String, Object> changed = new TreeMap<>(values);
        if (checked.equals(setting.usual())) {
            changed.remove(setting.key());
        } else {
            changed.put(setting.key(), checked);
        }
        return new ChosenSettings(Collections.unmodifiableMap(changed));
    }

    /** The same with other values of all settings of one method. */
    public ChosenSettings with(MethodSettings settings) {
        ChosenSettings changed = this;
        for (MethodSetting setting : settings.method().settings()) {
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
}
