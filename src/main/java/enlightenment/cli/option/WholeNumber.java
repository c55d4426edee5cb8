package enlightenment.cli.option;

import picocli.CommandLine.ITypeConverter;

/** A whole number between two limits, both included. Options name subclasses, which have their limits. */
public abstract class WholeNumber implements ITypeConverter<Integer> {
    private final int min;
    private final int max;

    protected WholeNumber(int min, int max) {
        this.min = min;
        this.max = max;
    }

    @Override
    public final Integer convert(String text) {
        try {
            int value = Integer.parseInt(text);
            if (value >= min && value <= max) {
                return value;
            }
        } catch (NumberFormatException e) {
            // Refused below, as a number out of range is.
        }
        throw BadValue.expected("a whole number in " + min + ".." + max, text);
    }

    /**
     * Whole numbers with a separator between them.
     *
     * @return null if the text is anything else than that many of them
     */
    public static int[] several(String text, String separator, int count) {
        String[] parts = text.split(separator, -1);
        if (parts.length != count) {
            return null;
        }
        int[] numbers = new int[count];
        for (int i = 0; i < count; i++) {
            try {
                numbers[i] = Integer.parseInt(parts[i]);
            } catch (NumberFormatException e) {
                return null;
            }
        }
        return numbers;
    }

    /** A TCP port, or 0 for any that is free. */
    public static final class Port extends WholeNumber {
        public static final int MAX = 65_535;

        Port() {
            super(0, MAX);
        }
    }

    /** A number of threads. */
    public static final class Threads extends WholeNumber {
        public static final int MAX = 4096;

        Threads() {
            super(1, MAX);
        }
    }
}
