package enlightenment.film;

import enlightenment.image.Image;

/**
 * The picture in the making: the mean of each finished pixel. Tiles cover disjoint pixels, so the order in which threads
 * put them does not matter.
 */
public final class Film {
    private final int x;
    private final int y;
    private final int width;
    private final int height;
    private final double[] rgb;

    /** A film for a rectangle of the whole picture. */
    public Film(int x, int y, int width, int height) {
        this.x = x;
        this.y = y;
        this.width = width;
        this.height = height;
        rgb = new double[Math.toIntExact(3L * width * height)];
    }

    /** Puts a finished tile. */
    public void put(FilmTile tile) {
        for (int row = tile.y; row < tile.y + tile.height; row++) {
            int k = 3 * ((row - y) * width + tile.x - x);
            for (int column = tile.x; column < tile.x + tile.width; column++) {
                for (int c = 0; c < 3; c++) {
                    rgb[k++] = tile.mean(column, row, c);
                }
            }
        }
    }

    /** Component 0, 1 or 2 of the pixel in column and row of the whole picture, in full precision. */
    public double component(int column, int row, int c) {
        return rgb[3 * ((row - y) * width + column - x) + c];
    }

    /** The picture as it stands. */
    public Image toImage() {
        float[] pixels = new float[rgb.length];
        for (int i = 0; i < rgb.length; i++) {
            pixels[i] = (float) rgb[i];
        }
        return new Image(width, height, pixels);
    }
}
