package enlightenment.work;

import enlightenment.check.Check;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.Shading;

/**
 * The memory that a picture takes while it is rendered and when it is finished. Bytes per pixel are those of the arrays of the classes
 * that are named; what a scene takes comes on top.
 *
 * @param settings the picture, of which only its size and region matter
 * @param isLinear whether pixels are linear light, as those of physical shading are
 * @param films what the pixels are made in
 * @param moreImages how many other images as large as the picture are needed
 */
public record PictureMemory(RenderSettings settings, boolean isLinear, Films films, int moreImages) {
    /** The films of {@code enlightenment.film} that a picture is made in. */
    public enum Films {
        /** A film of finished tiles. */
        TILES,

        /** One of paths that may end anywhere. */
        SPLATS,

        /** One of each, and the sum of the two. */
        BOTH
    }

    /** Of a film of tiles: three doubles, two floats and a count. */
    private static final int FILM = 3 * Double.BYTES + 2 * Float.BYTES + Integer.BYTES;

    /** What such a film of linear light has as well: the means of the four quarters of the samples, three floats each. */
    private static final int QUARTER_MEANS = 4 * 3 * Float.BYTES;

    /** Of a film of paths that may end anywhere: four groups of three longs. */
    private static final int SPLAT_FILM = 4 * 3 * Long.BYTES;

    /** Of an image: three floats. */
    private static final int IMAGE = 3 * Float.BYTES;

    /** Of an estimated error: the variance. */
    private static final int VARIANCE = Float.BYTES;

    /** While that of linear light is estimated: two figures, and whether a pixel is rare. */
    private static final int LINEAR_FIGURES = 2 * Float.BYTES + 1;

    /** While that of splats is estimated: the variance, not rounded yet. */
    private static final int SPLAT_FIGURES = Double.BYTES;

    /** Of splats over pixels with few samples of linear light: two figures of either. */
    private static final int FEW_SAMPLES = 4 * Float.BYTES;

    /** What the program itself takes, at least. */
    private static final long PROGRAM = 8L << 20;

    /** Arrays have no more. */
    private static final long MOST_NUMBERS = Integer.MAX_VALUE - 8;

    /** Of a picture of a scene. */
    public static PictureMemory of(Scene scene, RenderSettings settings, Films films, int moreImages) {
        return new PictureMemory(settings, scene.shading() instanceof Shading.Physical, films, moreImages);
    }

    /** Bytes for films, images and the estimated error, at most at any moment. */
    public long bytes() {
        return pixels() * bytesPerPixel();
    }

    private int bytesPerPixel() {
        int film = FILM + (isLinear ? QUARTER_MEANS : 0);
        int figures = isLinear ? LINEAR_FIGURES : 0;
        return (1 + moreImages) * IMAGE
                + VARIANCE
                + switch (films) {
                    case TILES -> film + figures;
                    case SPLATS -> SPLAT_FILM + SPLAT_FIGURES;
                    case BOTH -> 2 * film + SPLAT_FILM + figures + (isLinear ? FEW_SAMPLES : 0);
                };
    }

    /** Whether there is memory for it. */
    public boolean isEnough() {
        return bytes() <= available() && numbersPerArray() <= MOST_NUMBERS;
    }

    /**
     * Refuses a picture that cannot fit, before anything is allocated.
     *
     * @throws enlightenment.math.InvalidValueException if there is less memory
     */
    public void check() {
        check("");
    }

    /**
     * As {@link #check()}.
     *
     * @param reason why the picture must be in memory, as the end of the message
     */
    public void check(String reason) {
        RenderSettings.Crop region = settings.region();
        double share = Math.min((double) available() / bytes(), (double) MOST_NUMBERS / numbersPerArray());
        Check.that(
                isEnough(),
                "size",
                "a picture of " + region.width() + "x" + region.height() + " pixels needs " + bytes()
                        + " bytes of memory; at most " + available()
                        + " are there (java -Xmx sets the limit), for about "
                        + scaled(region.width(), share) + "x" + scaled(region.height(), share) + " pixels" + reason);
    }

    private static long available() {
        return Math.max(Runtime.getRuntime().maxMemory() - PROGRAM, 0);
    }

    /** Of the longest array. */
    private long numbersPerArray() {
        return pixels() * (isLinear && films != Films.SPLATS ? QUARTER_MEANS / Float.BYTES : 3);
    }

    /** A side of a picture with this share of the pixels. */
    private static int scaled(int side, double share) {
        return Math.max((int) (side * Math.sqrt(share)), 1);
    }

    private long pixels() {
        RenderSettings.Crop region = settings.region();
        return (long) region.width() * region.height();
    }
}
