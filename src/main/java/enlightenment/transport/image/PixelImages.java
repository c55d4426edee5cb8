package enlightenment.transport.image;

import enlightenment.world.light.ClippedPolygon;
import enlightenment.world.light.LightImage;
import java.util.Arrays;
import java.util.Comparator;
import java.util.stream.IntStream;

/** What of lights' images is in one pixel. Immutable but for the last place. */
final class PixelImages {
    /** So few images are all taken: numbers that choose among them are spread so evenly that hidden ones make little noise. */
    private static final int FEW = 4;

    /** What is so much brighter than what is behind it is worth sampling apart (docs/notes/path-tracing.md). */
    private static final double CLEARLY_BRIGHTER = 2;

    final int column;
    final int row;

    /** How many images count here. */
    final int count;

    private final ImagePart[] parts;

    /** The same in the order of lights. */
    private final ImagePart[] byLight;

    /** The sums of area times brightness. */
    private final double[] sums;

    /** The part that was chosen, and where in it. */
    ImagePart chosen;

    /** The inverse of the density with which that was done, over the pixel. */
    double share;

    private PixelImages(int column, int row, ImagePart[] parts) {
        this.column = column;
        this.row = row;
        this.parts = parts;
        count = parts.length;
        byLight = parts.clone();
        Arrays.sort(byLight, Comparator.comparingInt(p -> p.image.light));
        sums = new double[parts.length];
        double sum = 0;
        for (int k = 0; k < parts.length; k++) {
            sum += parts[k].area * parts[k].image.brightness;
            sums[k] = sum;
        }
    }

    /**
     * Finds what is in a pixel: of images that do not cover it entirely, and that are bright enough beside all of them, the part that is
     * in it.
     *
     * @param images holds all that reach into the pixel, in the order of all of the picture
     * @param count how many
     * @param work is overwritten
     */
    static PixelImages of(int column, int row, LightImage[] images, int count, ClippedPolygon work) {
        LightImage[] found = new LightImage[count];
        double[] areas = new double[count];
        int size = 0;
        for (int k = 0; k < count; k++) {
            LightImage image = images[k];
            if (image.reaches(column, row, column + 1.0, row + 1.0)) {
                work.set(image.x, image.y, column, row, column + 1.0, row + 1.0);
                double area = work.area();
                if (area > 0 && area < 1) {
                    found[size] = image;
                    areas[size++] = area;
                }
            }
        }
        double least = leastBrightness(found, areas, size);
        ImagePart[] parts = new ImagePart[size];
        int taken = 0;
        for (int k = 0; k < size; k++) {
            LightImage image = found[k];
            if (image.brightness >= least) {
                work.set(image.x, image.y, column, row, column + 1.0, row + 1.0);
                parts[taken++] = new ImagePart(image, areas[k], work.copyOfX(), work.copyOfY());
            }
        }
        return new PixelImages(column, row, Arrays.copyOf(parts, taken));
    }

    /**
     * The least brightness of the images that are sampled apart. Each sample takes one of them and has the sum of area times brightness,
     * or nothing, if that one is hidden. Where they are many, that is by chance. With a sum that is no more than any of their
     * brightnesses, its mean square is at most what the lamps themselves have where samples meet them by chance, whatever is hidden; the
     * triangles of a closed mesh, half of which is behind the other half, would make noise of what is even. Those that are left out are
     * dimmer than the sum, so that no sample can miss much.
     */
    private static double leastBrightness(LightImage[] images, double[] areas, int size) {
        double sum = 0;
        double least = Double.POSITIVE_INFINITY;
        for (int k = 0; k < size; k++) {
            sum += areas[k] * images[k].brightness;
            least = Math.min(least, images[k].brightness);
        }
        return size <= FEW || sum <= least ? 0 : leastOfBrightest(images, areas, size);
    }

    /** The same where not all of them can be taken: of the brightest, as many as fit and are clearly brighter than those left out. */
    private static double leastOfBrightest(LightImage[] images, double[] areas, int size) {
        int[] order = IntStream.range(0, size)
                .boxed()
                .sorted(Comparator.comparingDouble(k -> -images[k].brightness))
                .mapToInt(k -> k)
                .toArray();
        double sum = 0;
        double least = Double.POSITIVE_INFINITY;
        for (int k = 0; k < size; k++) {
            double brightness = images[order[k]].brightness;
            sum += areas[order[k]] * brightness;
            if (sum > brightness) {
                break;
            }
            if (k + 1 == size || brightness >= CLEARLY_BRIGHTER * images[order[k + 1]].brightness) {
                least = brightness;
            }
        }
        return least;
    }

    /** The first of the images of a light, among them by lights; or where it would be. */
    int firstOf(int light) {
        int low = 0;
        int high = count;
        while (low < high) {
            int middle = (low + high) >>> 1;
            if (byLight[middle].image.light < light) {
                low = middle + 1;
            } else {
                high = middle;
            }
        }
        return low;
    }

    /** An image by its place among them by lights; null if it is none of the light. */
    ImagePart of(int light, int at) {
        return at < count && byLight[at].image.light == light ? byLight[at] : null;
    }

    /** Chooses one of the parts, of which there is one, and a place in it: brighter and larger ones more often. */
    void choose(double u, double v) {
        int last = sums.length - 1;
        double at = u * sums[last];
        int k = firstAbove(at);
        double before = k == 0 ? 0 : sums[k - 1];
        chosen = parts[k];
        chosen.sample(Math.min((at - before) / (sums[k] - before), 1), v);
        share = sums[last] / chosen.image.brightness;
    }

    /** The first sum that is greater, or the last one. */
    private int firstAbove(double at) {
        int low = 0;
        int high = count - 1;
        while (low < high) {
            int middle = (low + high) >>> 1;
            if (at >= sums[middle]) {
                low = middle + 1;
            } else {
                high = middle;
            }
        }
        return low;
    }
}
