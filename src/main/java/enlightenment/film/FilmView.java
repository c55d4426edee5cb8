package enlightenment.film;

/** The pixels of a film, by their places in the whole picture. */
interface FilmView {
    /** The number of samples; 0 for an unfinished pixel. */
    int count(int column, int row);

    /** The mean of component c. */
    double component(int column, int row, int c);

    /** {@link FilmPixel#halves}. */
    float halves(int column, int row);

    /** {@link FilmPixel#quarters}. */
    float quarters(int column, int row);

    /** Writes {@link FilmPixel#ofQuarters}; only of linear light. */
    void quarterMeans(int column, int row, double[] out);
}
