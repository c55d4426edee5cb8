package enlightenment.shading;

import java.util.Arrays;

/** What of lights' images is in one pixel. Immutable but for the last place. */
final class PixelImages {
    final int column;
    final int row;
    final ImagePart[] parts;

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
        sums = new double[parts.length];
        double sum = 0;
        for (int k = 0; k < parts.length; k++) {
            sum += parts[k].area * parts[k].image.brightness;
            sums[k] = sum;
        }
    }

    /**
     * Finds what is in a pixel: of images that do not cover it entirely, the part that is in it.
     *
     * @param images holds all that reach into the pixel, in the order of all of the picture
     * @param count how many
     * @param work is overwritten
     */
    static PixelImages of(int column, int row, LightImage[] images, int count, ClippedPolygon work) {
        ImagePart[] found = new ImagePart[count];
        int size = 0;
        for (int k = 0; k < count; k++) {
            LightImage image = images[k];
            if (image.reaches(column, row, column + 1.0, row + 1.0)) {
                work.set(image.x, image.y, column, row, column + 1.0, row + 1.0);
                double area = work.area();
                if (area > 0 && area < 1) {
                    found[size++] = new ImagePart(image, area, work.copyOfX(), work.copyOfY());
                }
            }
        }
        return new PixelImages(column, row, Arrays.copyOf(found, size));
    }

    /** Chooses one of the parts, of which there is one, and a place in it: brighter and larger ones more often. */
    void choose(double u, double v) {
        int last = sums.length - 1;
        double at = u * sums[last];
        int k = 0;
        while (k < last && at >= sums[k]) {
            k++;
        }
        double before = k == 0 ? 0 : sums[k - 1];
        chosen = parts[k];
        chosen.sample(Math.min((at - before) / (sums[k] - before), 1), v);
        share = sums[last] / chosen.image.brightness;
    }
}
