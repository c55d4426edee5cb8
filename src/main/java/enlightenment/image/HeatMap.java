package enlightenment.image;

import java.util.Arrays;

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

    /** What the numbers of the scale need; five rows of three dots each, the upper left dot in the highest bit. */
    private static final String SIGNS = "01257.";

    private static final int[] SIGN_DOTS = {
        0b111_101_101_101_111,
        0b010_110_010_010_111,
        0b111_001_111_100_111,
        0b111_100_111_001_111,
        0b111_001_010_010_010,
        0b000_000_000_000_010
    };

    private HeatMap() {}

    /** The error of each pixel as a colour; as large as the images. */
    public static Image of(Flip flip) {
        return new Image(flip.width(), flip.height(), colors(flip, 0));
    }

    /**
     * The same with a scale below it that runs from 0 to 1 over the picture's width: 15 rows, or 30 from 400 columns on. A
     * picture of less than 32 columns gets none.
     */
    public static Image withScale(Flip flip) {
        if (flip.width() < NARROWEST_WITH_SCALE) {
            return of(flip);
        }
        int dot = flip.width() < LARGE ? 1 : 2;
        int scaleRows = dot * SCALE_HEIGHT;
        float[] rgb = colors(flip, scaleRows);
        int width = flip.width();
        int top = flip.height();
        for (int y = top + dot * GAP; y < top + dot * (GAP + BAR); y++) {
            for (int x = 0; x < width; x++) {
                Magma.write(x / (width - 1.0), rgb, 3 * (y * width + x));
            }
        }
        int line = top + dot * (GAP + BAR + GAP);
        String[] labels =
                width < WIDE ? new String[] {"0", "0.5", "1"} : new String[] {"0", "0.25", "0.5", "0.75", "1"};
        for (int i = 0; i < labels.length; i++) {
            int length = dot * (labels[i].length() * (DIGIT_WIDTH + 1) - 1);
            // Centred below its value, but within the picture.
            int center = i * (width - 1) / (labels.length - 1);
            int left = Math.min(Math.max(center - length / 2, dot), width - dot - length);
            print(labels[i], rgb, width, left, line, dot);
        }
        return new Image(width, top + scaleRows, rgb);
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
