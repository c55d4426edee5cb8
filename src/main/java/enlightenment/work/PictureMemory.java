package enlightenment.work;

import enlightenment.check.Check;
import enlightenment.scene.RenderSettings;

/** The memory that a picture takes while it is rendered. */
public final class PictureMemory {
    /** A film keeps three doubles, two floats and a count per pixel, the finished picture three floats. */
    private static final long BYTES_PER_PIXEL = 3 * (8 + 4) + 3 * 4;

    /** Another image as large as the picture. */
    private static final long BYTES_PER_IMAGE_PIXEL = 3 * 4;

    /** What a film of paths that may end anywhere takes more than that of tiles, in images: four groups of three longs per pixel. */
    public static final int IMAGES_OF_SPLATS = (4 * 3 * 8 - 3 * (8 + 4)) / (3 * 4);

    /**
     * What paths that may end anywhere take beside a film of tiles, in images: a film of their own, and the sum of the two when somebody
     * looks at it.
     */
    public static final int IMAGES_OF_ADDED_SPLATS = (4 * 3 * 8 + 3 * (8 + 4)) / (3 * 4);

    /** Arrays have no more. */
    private static final long MOST_NUMBERS = Integer.MAX_VALUE - 8;

    private PictureMemory() {}

    /** Bytes for the film and the finished picture. */
    public static long bytes(RenderSettings settings) {
        return pixels(settings) * BYTES_PER_PIXEL;
    }

    /**
     * Refuses a picture that cannot fit, before anything is allocated.
     *
     * @param moreImages how many other images as large as the picture are needed
     * @throws enlightenment.math.InvalidValueException if there is less memory
     */
    public static void check(RenderSettings settings, int moreImages) {
        check(settings, moreImages, "");
    }

    /**
     * As {@link #check(RenderSettings, int)}.
     *
     * @param reason why the picture must be in memory, as the end of the message
     */
    public static void check(RenderSettings settings, int moreImages, String reason) {
        RenderSettings.Crop region = settings.region();
        long needed = bytes(settings) + moreImages * BYTES_PER_IMAGE_PIXEL * pixels(settings);
        long available = Runtime.getRuntime().maxMemory();
        double share = Math.min((double) available / needed, (MOST_NUMBERS / 3.0) / pixels(settings));
        Check.that(
                needed <= available && 3 * pixels(settings) <= MOST_NUMBERS,
                "size",
                "a picture of " + region.width() + "x" + region.height() + " pixels needs " + needed
                        + " bytes of memory; at most " + available + " are there (java -Xmx sets the limit), for about "
                        + scaled(region.width(), share) + "x" + scaled(region.height(), share) + " pixels" + reason);
    }

    /** Whether there is memory for a picture and this many other images as large. */
    public static boolean isEnough(RenderSettings settings, int moreImages) {
        return bytes(settings) + moreImages * BYTES_PER_IMAGE_PIXEL * pixels(settings)
                <= Runtime.getRuntime().maxMemory();
    }

    /** A side of a picture with this share of the pixels. */
    private static int scaled(int side, double share) {
        return Math.max((int) (side * Math.sqrt(share)), 1);
    }

    private static long pixels(RenderSettings settings) {
        RenderSettings.Crop region = settings.region();
        return (long) region.width() * region.height();
    }
}
