package enlightenment.picture;

import enlightenment.image.Image;
import enlightenment.image.flip.Flip;
import java.util.Arrays;
import java.util.List;

/**
 * Pictures of where two images differ, in the colour map magma: black is no difference, pale yellow the largest. Made of
 * numbers only, without the fonts of a machine: the same error gives the same bits everywhere.
 */
public final class HeatMap {
    /** Pictures narrower than this have no room for the numbers of a scale. */
    private static final int NARROWEST_WITH_SCALE = 32;

    /** From this width on there is room for five numbers, and from the other on for larger ones. */
    private static final int WIDE = 120;

    private static final int LARGE = 400;

    /** Heights within the scale, in dots: gap, bar, gap, digits, gap. */
    private static final int GAP = 2;

    private static final int BAR = 4;
    private static final int DIGIT_WIDTH = 3;
    private static final int DIGIT_HEIGHT = 5;
    private static final int SCALE_HEIGHT = GAP + BAR + GAP + DIGIT_HEIGHT + GAP;
    private static final float INK = 0.8f;

    /** What the numbers of a scale need; five rows of three dots each, the upper left dot in the highest bit. */
    private static final String SIGNS = "0123456789.";

    private static final int[] SIGN_DOTS = {
        0b111_101_101_101_111,
        0b010_110_010_010_111,
        0b111_001_111_100_111,
        0b111_001_011_001_111,
        0b101_101_111_001_001,
        0b111_100_111_001_111,
        0b111_100_111_101_111,
        0b111_001_010_010_010,
        0b111_101_111_101_111,
        0b111_101_111_001_111,
        0b000_000_000_000_010
    };

    private HeatMap() {}

    /** The error of each pixel as a colour; as large as the images. */
    public static Image of(Flip flip) {
        return new Image(flip.width(), flip.height(), colors(flip, 0));
    }

    /**
     * Any map of numbers, without a scale.
     *
     * @param width in pixels
     * @param height in pixels
     * @param shares for each pixel, row by row, how far up the scale it is: 0..1, what lies outside gets the colour of the end
     */
    public static Image of(int width, int height, float[] shares) {
        return new Image(width, height, colors(width, height, shares, height));
    }

    /**
     * {@link #of(Flip)} with a scale below it that runs from 0 to 1 over the picture's width. It has 15 rows, or 30 from 400 columns on. A
     * picture of less than 32 columns gets none.
     */
    public static Image withScale(Flip flip) {
        float[] rgb = colors(flip, scaleRows(flip.width()));
        List<String> labels = flip.width() < WIDE ? List.of("0", "0.5", "1") : List.of("0", "0.25", "0.5", "0.75", "1");
        return scaled(flip.width(), flip.height(), rgb, labels);
    }

    /**
     * Any map of numbers, with the same scale below it. Where the numbers need more room than there is, only those at its
     * ends are shown, or none.
     *
     * @param width in pixels
     * @param height in pixels
     * @param shares for each pixel, row by row, how far up the scale it is: 0..1, what lies outside gets the colour of the end
     * @param labels two or more numbers, digits and points only, spread evenly over the scale
     * @throws IllegalArgumentException if the labels are too few or have other characters
     */
    public static Image withScale(int width, int height, float[] shares, List<String> labels) {
        if (labels.size() < 2 || labels.stream().anyMatch(l -> l.chars().anyMatch(c -> SIGNS.indexOf(c) < 0))) {
            throw new IllegalArgumentException("a scale needs two or more numbers, unlike " + labels);
        }
        int rows = Math.addExact(height, scaleRows(width));
        return scaled(width, height, colors(width, height, shares, rows), labels);
    }

    private static int scaleRows(int width) {
        return width < NARROWEST_WITH_SCALE ? 0 : (width < LARGE ? 1 : 2) * SCALE_HEIGHT;
    }

    /** Draws the scale, if there are rows for it. */
    private static Image scaled(int width, int top, float[] rgb, List<String> numbers) {
        int scaleRows = scaleRows(width);
        if (scaleRows == 0) {
            return new Image(width, top, rgb);
        }
        int dot = width < LARGE ? 1 : 2;
        for (int y = top + dot * GAP; y < top + dot * (GAP + BAR); y++) {
            for (int x = 0; x < width; x++) {
                Magma.write(x / (width - 1.0), rgb, 3 * (y * width + x));
            }
        }
        int line = top + dot * (GAP + BAR + GAP);
        List<String> labels = fitting(numbers, width, dot);
        for (int i = 0; i < labels.size(); i++) {
            print(labels.get(i), rgb, width, left(labels, i, width, dot), line, dot);
        }
        return new Image(width, top + scaleRows, rgb);
    }

    /** All numbers, those at the ends, or none: whichever first fits with room for a digit between any two. */
    private static List<String> fitting(List<String> labels, int width, int dot) {
        if (fit(labels, width, dot)) {
            return labels;
        }
        List<String> ends = List.of(labels.get(0), labels.get(labels.size() - 1));
        return fit(ends, width, dot) ? ends : List.of();
    }

    private static boolean fit(List<String> labels, int width, int dot) {
        int free = dot;
        for (int i = 0; i < labels.size(); i++) {
            int left = left(labels, i, width, dot);
            if (left < free) {
                return false;
            }
            free = left + length(labels.get(i), dot) + dot * DIGIT_WIDTH;
        }
        return true;
    }

    /** Where a number begins: centred below its value, but within the picture. */
    private static int left(List<String> labels, int i, int width, int dot) {
        int length = length(labels.get(i), dot);
        int center = (int) ((long) i * (width - 1) / (labels.size() - 1));
        return Math.min(Math.max(center - length / 2, dot), width - dot - length);
    }

    private static int length(String label, int dot) {
        return dot * (label.length() * (DIGIT_WIDTH + 1) - 1);
    }

    private static float[] colors(int width, int height, float[] shares, int rows) {
        if (shares.length != (long) width * height) {
            throw new IllegalArgumentException(width + " x " + height + " pixels, but " + shares.length + " numbers");
        }
        float[] rgb = new float[Math.multiplyExact(3, Math.multiplyExact(width, rows))];
        for (int i = 0; i < shares.length; i++) {
            Magma.write(shares[i], rgb, 3 * i);
        }
        return rgb;
    }

    private static float[] colors(Flip flip, int moreRows) {
        int rows = Math.addExact(flip.height(), moreRows);
        float[] rgb = new float[Math.multiplyExact(3, Math.multiplyExact(flip.width(), rows))];
        int i = 0;
        for (int y = 0; y < flip.height(); y++) {
            for (int x = 0; x < flip.width(); x++) {
                Magma.write(flip.error(x, y), rgb, i);
                i += 3;
            }
        }
        return rgb;
    }

    private static void print(String text, float[] rgb, int width, int left, int top, int dot) {
        for (int n = 0; n < text.length(); n++) {
            int dots = SIGN_DOTS[SIGNS.indexOf(text.charAt(n))];
            for (int i = 0; i < DIGIT_WIDTH * DIGIT_HEIGHT; i++) {
                if ((dots >> DIGIT_WIDTH * DIGIT_HEIGHT - 1 - i & 1) == 0) {
                    continue;
                }
                int x = left + dot * (n * (DIGIT_WIDTH + 1) + i % DIGIT_WIDTH);
                for (int y = top + dot * (i / DIGIT_WIDTH); y < top + dot * (i / DIGIT_WIDTH + 1); y++) {
                    Arrays.fill(rgb, 3 * (y * width + x), 3 * (y * width + x + dot), INK);
                }
            }
        }
    }
}
