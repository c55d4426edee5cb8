package enlightenment.film;

/** What each pixel of a picture tells of its error, in the order of rows, as often as it is asked for. */
interface PixelFigures {
    /** Goes through all pixels, also those that are not finished. */
    void forEach(Visitor visitor);

    /** The number of pixels where a number for each fits in memory; otherwise 0. */
    int pixelsInMemory();

    /** Receives the figures of pixels. */
    @FunctionalInterface
    interface Visitor {
        /**
         * The next pixel.
         *
         * @param first {@link FilmTile#halves}
         * @param second {@link FilmTile#quarters}
         * @param count the number of samples, 0 for an unfinished pixel
         * @param rare {@link QuarterMeans#isRare}; of no meaning where pixels are display-referred
         */
        void pixel(float first, float second, int count, boolean rare);
    }

    /**
     * Those of arrays with a number for each pixel.
     *
     * @param rare null for display-referred pixels
     */
    static PixelFigures of(float[] first, float[] second, int[] counts, boolean[] rare) {
        return new PixelFigures() {
            @Override
            public void forEach(Visitor visitor) {
                for (int i = 0; i < counts.length; i++) {
                    visitor.pixel(first[i], second[i], counts[i], rare != null && rare[i]);
                }
            }

            @Override
            public int pixelsInMemory() {
                return counts.length;
            }
        };
    }
}
