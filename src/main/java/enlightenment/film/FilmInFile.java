package enlightenment.film;

import enlightenment.color.DisplayCurve;
import enlightenment.file.ScratchFile;
import enlightenment.image.Image;
import enlightenment.picture.ReducedPicture;
import java.nio.ByteBuffer;
import java.nio.file.Path;
import java.util.Arrays;

/**
 * A film of pixels that do not fit in memory: it has the numbers of {@link Film}, bit by bit. Its memory is that of three rows of blocks.
 *
 * <p>The file has 8 × 8 pixels of the whole picture together: tiles are wide and low or narrow and high, and rows are read.
 */
public final class FilmInFile extends TileFilm {
    private static final int SIDE = FilmBand.SIDE;

    /** Rows of blocks that are kept: those of a pixel and of its neighbours. */
    private static final int BANDS = 3;

    /** Bytes of a pixel of the finished picture: three floats. */
    private static final int IMAGE_BYTES = 3 * Float.BYTES;

    /** Bytes of a pixel's figures, which the error is estimated from. */
    private static final int FIGURE_BYTES = 2 * Float.BYTES + Integer.BYTES;

    /** The most pixels that are read one by one, for previews: a second's work at most. */
    private static final int MOST_SHOWN = ReducedPicture.MOST_PIXELS;

    private final boolean isLinear;
    private final Path folder;
    private final ScratchFile file;
    private final int pixelBytes;

    /** The first column of blocks of the whole picture that has pixels of the film, and their number. */
    private final int firstBlock;

    private final int blocks;
    private final FilmBand[] bands = new FilmBand[BANDS];
    private final int[] bandRows = new int[BANDS];

    /** The pixels' error figures; null until they are needed, and after another tile. */
    private FigureFile figures;

    private LinearFigures light;
    private double contrast;

    /** Light splatted over pixels with one to three samples of linear light; null for none. */
    private final FewSamplesSplats fewSplats;

    /**
     * A film for a rectangle of the whole picture.
     *
     * @param folder where its files are, as long as the film and its image are in use
     */
    public FilmInFile(int x, int y, int width, int height, DisplayCurve curve, Path folder) {
        this(x, y, width, height, curve, folder, null);
    }

    private FilmInFile(
            int x, int y, int width, int height, DisplayCurve curve, Path folder, FewSamplesSplats fewSplats) {
        super(x, y, width, height, curve);
        this.fewSplats = fewSplats;
        this.folder = folder;
        isLinear = isLinear();
        pixelBytes = FilmPixel.bytes(isLinear);
        firstBlock = x / SIDE;
        blocks = (x + width - 1) / SIDE - firstBlock + 1;
        file = ScratchFile.in(folder);
        Arrays.fill(bandRows, -1);
    }

    /** Bytes per pixel of all files together, until the picture is written. */
    public static int bytesPerPixel(boolean isLinear) {
        return FilmPixel.bytes(isLinear) + IMAGE_BYTES + FIGURE_BYTES;
    }

    /** Bytes per pixel of all files together where splats are added: of two films, the splats, and pixels with few samples. */
    public static int bytesPerPixelWithSplats(boolean isLinear) {
        return FilmPixel.bytes(isLinear)
                + bytesPerPixel(isLinear)
                + SplatFilmInFile.bytesPerPixel()
                + (isLinear ? FewSamplesFile.BYTES : 0);
    }

    /** Bytes of memory that a film of this size takes, at most at any moment. */
    public static long memory(int columns, int rows, boolean isLinear) {
        return (BANDS + 1L) * SIDE * (columns + 2L * SIDE) * FilmPixel.bytes(isLinear)
                + (isLinear ? LinearFigures.memory(columns, rows) : 0);
    }

    @Override
    public void put(int left, int top, int columns, int rows, Source source) {
        int first = left / SIDE;
        int across = (left + columns - 1) / SIDE - first + 1;
        ByteBuffer buffer = ByteBuffer.allocate(pixelBytes * SIDE * SIDE * across);
        FilmPixel pixel = new FilmPixel();
        int bottom = top + rows;
        for (int from = top; from < bottom; from = (from / SIDE + 1) * SIDE) {
            int to = Math.min((from / SIDE + 1) * SIDE, bottom);
            for (int row = from; row < to; row++) {
                for (int column = left; column < left + columns; column++) {
                    source.read(column, row, pixel);
                    buffer.position(pixelBytes * FilmBand.index(column - first * SIDE, row));
                    pixel.write(buffer, isLinear);
                }
            }
            write(buffer.array(), left, columns, from, to);
        }
        synchronized (this) {
            Arrays.fill(bandRows, -1);
            forgetFigures();
        }
    }

    private void forgetFigures() {
        if (figures != null) {
            figures.close();
            figures = null;
        }
    }

    /** Writes some rows of pixels of one row of blocks: at once if no other tile has pixels of these blocks. */
    private void write(byte[] bytes, int left, int columns, int from, int to) {
        int first = left / SIDE;
        int last = (left + columns - 1) / SIDE;
        int top = Math.max(from / SIDE * SIDE, y);
        int bottom = Math.min((from / SIDE + 1) * SIDE, y + height);
        boolean isWhole = left == Math.max(first * SIDE, x)
                && left + columns == Math.min((last + 1) * SIDE, x + width)
                && from == top
                && to == bottom;
        long start = position(first, from / SIDE);
        if (isWhole) {
            file.write(start, bytes, 0, bytes.length);
            return;
        }
        for (int row = from; row < to; row++) {
            for (int block = first; block <= last; block++) {
                int begin = Math.max(block * SIDE, left);
                int end = Math.min((block + 1) * SIDE, left + columns);
                int at = pixelBytes * FilmBand.index(begin - first * SIDE, row);
                file.write(start + at, bytes, at, pixelBytes * (end - begin));
            }
        }
    }

    private long position(int block, int blockRow) {
        return ((long) (blockRow - y / SIDE) * blocks + block - firstBlock) * (SIDE * SIDE * pixelBytes);
    }

    /** The row of blocks that a row of pixels belongs to. */
    private synchronized FilmBand band(int row) {
        int blockRow = row / SIDE;
        int slot = blockRow % BANDS;
        if (bandRows[slot] != blockRow) {
            byte[] bytes = new byte[blocks * SIDE * SIDE * pixelBytes];
            file.read(position(firstBlock, blockRow), bytes, bytes.length);
            bands[slot] = new FilmBand(bytes, firstBlock * SIDE, pixelBytes);
            bandRows[slot] = blockRow;
        }
        return bands[slot];
    }

    /** The pixels as they stand, to be read by one thread, row by row. */
    private final class View implements FilmView {
        private final FilmBand[] near = new FilmBand[BANDS];
        private final int[] rows = new int[BANDS];

        View() {
            Arrays.fill(rows, -1);
        }

        private FilmBand at(int row) {
            int blockRow = row / SIDE;
            int slot = blockRow % BANDS;
            if (rows[slot] != blockRow) {
                near[slot] = band(row);
                rows[slot] = blockRow;
            }
            return near[slot];
        }

        @Override
        public int count(int column, int row) {
            return at(row).count(column, row);
        }

        @Override
        public double component(int column, int row, int c) {
            return at(row).component(column, row, c);
        }

        @Override
        public float halves(int column, int row) {
            return at(row).halves(column, row);
        }

        @Override
        public float quarters(int column, int row) {
            return at(row).quarters(column, row);
        }

        @Override
        public void quarterMeans(int column, int row, double[] out) {
            at(row).quarterMeans(column, row, out);
        }
    }

    @Override
    public int count(int column, int row) {
        return band(row).count(column, row);
    }

    @Override
    public float[] quarterMeans() {
        throw new IllegalStateException("the film is in a file");
    }

    @Override
    public synchronized ErrorEstimate error() {
        findFigures();
        return isLinear
                ? ErrorEstimate.ofLight(figures).with(light.error(fewSplats != null && fewSplats.isGrowing()))
                : ErrorEstimate.of(figures, ErrorEstimate.kind(areDifferences()), contrast);
    }

    @Override
    synchronized long samples() {
        findFigures();
        return figures.samples();
    }

    @Override
    FilmView view() {
        return new View();
    }

    @Override
    FewSamplesSplats fewSamples() {
        return new FewSamplesSplats(curve, new FewSamplesFile(folder));
    }

    @Override
    FilmInFile empty(FewSamplesSplats few) {
        return new FilmInFile(x, y, width, height, curve, folder, few);
    }

    private void findFigures() {
        if (figures != null) {
            return;
        }
        FigureFile found = new FigureFile(folder);
        if (isLinear) {
            LightPass pass = new LightPass(curve, x, y, width, height);
            light = pass.run(view(), pass.bandMeans(view()), fewSplats == null ? found : fewSplats.over(found));
        } else {
            contrast = showFigures(found);
        }
        figures = found;
    }

    /** Shows what display-referred pixels tell; returns the difference between their largest and smallest component. */
    private double showFigures(PixelFigures.Visitor visitor) {
        FilmView view = view();
        ErrorEstimate.Contrast range = new ErrorEstimate.Contrast();
        for (int row = y; row < y + height; row++) {
            for (int column = x; column < x + width; column++) {
                int count = view.count(column, row);
                for (int c = 0; count > 0 && c < 3; c++) {
                    range.add(view.component(column, row, c));
                }
                visitor.pixel(view.halves(column, row), view.quarters(column, row), count, false);
            }
        }
        return range.get();
    }

    /** The picture as it stands, in a file of its own that goes with it. */
    @Override
    public Image toImage() {
        FilmView view = view();
        ImageRows rows = new ImageRows(width, folder);
        float[] numbers = new float[3 * width];
        for (int row = y; row < y + height; row++) {
            for (int i = 0; i < numbers.length; i++) {
                numbers[i] = FloatLight.of(view.component(x + i / 3, row, i % 3), curve);
            }
            rows.add(numbers);
        }
        return Image.of(width, height, rows, curve);
    }

    /** Every n-th column and row, with the n that leaves {@link #MOST_SHOWN} pixels at most. */
    @Override
    public Image shown() {
        int step = ReducedPicture.step(width, height, MOST_SHOWN);
        int columns = ReducedPicture.side(width, step);
        int rows = ReducedPicture.side(height, step);
        float[] rgb = new float[3 * columns * rows];
        byte[] bytes = new byte[3 * Double.BYTES];
        ByteBuffer means = ByteBuffer.wrap(bytes);
        for (int i = 0; i < rgb.length; i += 3) {
            int column = x + i / 3 % columns * step;
            int row = y + i / 3 / columns * step;
            int within = FilmBand.index(column % SIDE, row);
            file.read(position(column / SIDE, row / SIDE) + (long) pixelBytes * within, bytes, bytes.length);
            for (int c = 0; c < 3; c++) {
                rgb[i + c] = FloatLight.of(means.getDouble(Double.BYTES * c), curve);
            }
        }
        return new Image(columns, rows, rgb, curve);
    }

    @Override
    public synchronized void release() {
        forgetFigures();
        if (fewSplats != null) {
            fewSplats.release();
        }
        file.close();
    }
}
