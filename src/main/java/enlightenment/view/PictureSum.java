package enlightenment.view;

import enlightenment.image.Image;

/** The mean of pictures of one size, each with a weight. For use by one thread. */
final class PictureSum {
    private double[] sums;
    private double weight;

    /**
     * Adds a picture.
     *
     * @param samples per pixel that it is the mean of, greater than 0
     * @return the mean of all pictures so far, with the curve of this one
     */
    Image add(Image image, int samples) {
        float[] rgb = image.toArray();
        if (sums == null) {
            sums = new double[rgb.length];
        }
        weight += samples;
        for (int i = 0; i < rgb.length; i++) {
            sums[i] += (double) rgb[i] * samples;
            rgb[i] = (float) (sums[i] / weight);
        }
        return new Image(image.width(), image.height(), rgb, image.curve());
    }
}
