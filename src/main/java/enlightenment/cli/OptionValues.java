package enlightenment.cli;

import enlightenment.scene.Scene;

/** Reads the values of options. Every message names the option, what was expected and what was given. */
final class OptionValues {
    private OptionValues() {}

    /** A whole number between two limits. */
    static int integer(String option, String text, int lo, int hi) {
        try {
            int value = Integer.parseInt(text);
            if (value >= lo && value <= hi) {
                return value;
            }
        } catch (NumberFormatException e) {
            // Told below, as a number out of range is.
        }
        throw wrong(option, "a whole number in " + lo + ".." + hi, text);
    }

    /** Any 64-bit whole number. */
    static long wholeNumber(String option, String text) {
        try {
            return Long.parseLong(text);
        } catch (NumberFormatException e) {
            throw wrong(option, "a whole number in " + Long.MIN_VALUE + ".." + Long.MAX_VALUE, text);
        }
    }

    /** A decimal number between two limits; what Java also takes for one, such as NaN or 1f, is none. */
    static double number(String option, String text, double lo, double hi) {
        if (text.matches("[+-]?(\\d+\\.?\\d*|\\.\\d+)([eE][+-]?\\d+)?")) {
            double value = Double.parseDouble(text);
            if (value >= lo && value <= hi) {
                return value;
            }
        }
        String limits =
                hi == Double.MAX_VALUE ? "of at least " + shorter(lo) : "in " + shorter(lo) + ".." + shorter(hi);
        throw wrong(option, "a number " + limits, text);
    }

    private static String shorter(double limit) {
        return limit == Math.rint(limit) ? Long.toString((long) limit) : RenderOptions.number(limit);
    }

    /** A picture's size: width and height. */
    static int[] size(String option, String text) {
        int[] size = numbers(text, "x", 2);
        if (size == null || !isSide(size[0]) || !isSide(size[1])) {
            throw wrong(option, "WIDTHxHEIGHT, two whole numbers in 1.." + Scene.MAX_SIDE + " such as 800x400", text);
        }
        return size;
    }

    private static boolean isSide(int side) {
        return side >= 1 && side <= Scene.MAX_SIDE;
    }

    /** A part of a picture: x, y, width, height. */
    static int[] crop(String option, String text) {
        int[] crop = numbers(text, ",", 4);
        if (crop == null) {
            throw wrong(option, "X,Y,WIDTH,HEIGHT, four whole numbers in pixels such as 0,0,100,50", text);
        }
        return crop;
    }

    /** A part: its number, counted from 1, and how many there are. */
    static int[] part(String option, String text) {
        int[] part = numbers(text, "/", 2);
        if (part == null || part[0] < 1 || part[1] < part[0]) {
            throw wrong(option, "I/N, part I of N, counted from 1, such as 3/16", text);
        }
        return part;
    }

    /** One of some words. */
    static String word(String option, String text, String... words) {
        for (String word : words) {
            if (word.equals(text)) {
                return word;
            }
        }
        throw wrong(option, words.length == 1 ? words[0] : "one of " + String.join(", ", words), text);
    }

    /** So many whole numbers, or null if the text is something else. */
    private static int[] numbers(String text, String separator, int count) {
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

    private static CliException wrong(String option, String expected, String given) {
        return CliException.wrongUsage(option + " must be " + expected + ", not \"" + given + "\"");
    }
}
