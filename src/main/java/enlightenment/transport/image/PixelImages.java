package enlightenment.transport.image;

import enlightenment.world.light.ClippedPolygon;
import enlightenment.world.light.LightImage;
import java.util.Arrays;
import java.util.Comparator;
import java.util.stream.IntStream;

/** The parts of light images within one pixel, and a distribution over them. Immutable but for the last sample. */
final class PixelImages {
    /**
     * Up to this number all images are sampled: stratified random numbers choose among them so evenly that hidden ones add little noise.
     */
    private static final int FEW = 4;

    /** The ratio of brightness to the next dimmer image from which sampling an image separately pays (docs/notes/path-tracing.md). */
    private static final double CLEARLY_BRIGHTER = 2;

    final int column;
    final int row;

    /** The number of image parts that are sampled. */
    final int count;

    private final ImagePart[] parts;

    /** The parts in the order of their lights. */
    private final ImagePart[] byLight;

    /** Cumulative sums of area times brightness. */
    private final double[] sums;

    /** The sampled part; it has the film position. */
    ImagePart chosen;

    /** The inverse of the density of that sample, over the pixel. */
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
     * Finds the image parts in a pixel: of images that do not cover the whole pixel, and that are bright enough compared to all of them.
     *
     * @param images holds all that reach into the pixel, in the order of the whole picture
     * @param count the number of images
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
     * The least brightness of an image that is sampled separately. Each sample chooses one image and gets the sum of area times brightness,
     * or 0 if that image is hidden. As long as the sum does not exceed any image's brightness, the mean square is at most that of samples
     * which hit the emitters without this strategy, whatever is hidden; beyond that, the triangles of a closed mesh, half of which the
     * other half hides, would turn constant radiance into noise. Images that are left out are dimmer than the sum, so that missing them
     * causes little error.
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

    /**
     * The least brightness where not all images can be sampled: of the brightest, as many as fit and are clearly brighter than the next.
     */
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

    /** The index, among the parts by light, of the first part of a light; or where it would be. */
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

    /** A part by its index among the parts by light; null if it belongs to another light. */
    ImagePart of(int light, int at) {
        return at < count && byLight[at].image.light == light ? byLight[at] : null;
    }

    /** Samples one of the parts, at least one, with probability proportional to area times brightness, and a film position in it. */
    void choose(double u, double v) {
        int last = sums.length - 1;
        double at = u * sums[last];
        int k = firstAbove(at);
        double before = k == 0 ? 0 : sums[k - 1];
        chosen = parts[k];
        chosen.sample(Math.min((at - before) / (sums[k] - before), 1), v);
        share = sums[last] / chosen.image.brightness;
    }

    /** The index of the first cumulative sum greater than this, or of the last one. */
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
