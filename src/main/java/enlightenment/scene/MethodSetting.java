package enlightenment.scene;

import enlightenment.check.Check;
import java.util.List;
import java.util.Locale;
import java.util.Objects;

/**
 * A setting of some methods, or of all ({@link CommonSettings}): what it is called, and which values it may have. In scene files it
 * is a key of the render part, on the command line an option.
 */
public sealed interface MethodSetting permits MethodSetting.Whole, MethodSetting.Word {
    /** The key in scene files and reports: letters and digits, a small letter first. It must be none of the render part's own. */
    String key();

    /** What it is, in some words without a full stop; ranges and defaults are told beside it. */
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
        if (!key.matches("[a-z][A-Za-z0-9]*") || List.of("method", "antialias").contains(key)) {
            throw new IllegalArgumentException(
                    "a setting needs a key of letters and digits of its own, not \"" + key + "\"");
        }
    }

    /**
     * A whole number.
     *
     * @param key as {@link MethodSetting#key}
     * @param min the least value
     * @param max the greatest value
     * @param usualValue the value where none is chosen
     * @param description as {@link MethodSetting#description}
     */
    record Whole(String key, long min, long max, long usualValue, String description) implements MethodSetting {
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
            Check.that(isWhole && number >= min && number <= max, key, "must lie in " + limits() + ", not " + value);
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
     * @param key as {@link MethodSetting#key}
     * @param words the values, the default first
     * @param description as {@link MethodSetting#description}
     */
    record Word(String key, List<String> words, String description) implements MethodSetting {
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
                    value instanceof String s && words.contains(s), key, "must be one of " + words + ", not " + value);
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
