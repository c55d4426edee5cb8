package enlightenment.engine;

import enlightenment.color.Color;
import enlightenment.color.DisplayCurve;
import enlightenment.film.FilmTile;
import enlightenment.film.TileGrowth;
import enlightenment.scene.RenderSettings;
import java.nio.ByteBuffer;
import java.util.Optional;
import java.util.function.Consumer;

/**
 * The pixels of a whole tile. For each pixel, row by row, the means of red, green and blue (8 bytes each), the two figures that its error
 * is estimated from (4 each) and the number of its samples (4); of linear light also the means of the four quarters of its samples (12 ×
 * 4), since splatted light may be added before errors are estimated. Where the tile can grow, behind all that follows for each pixel what
 * {@link TileGrowth} keeps of it.
 */
final class TileForm extends ResultForm {
    private static final int PER_PIXEL = 3 * Double.BYTES + 2 * Float.BYTES + Integer.BYTES;
    private static final int MEANS_OF_QUARTERS = 12;

    /** Display-referred means lie near 0..1; brighter light than this is a fault, not light. */
    static final double BRIGHTEST = 1 << 20;

    private final DisplayCurve display;
    private final boolean isLinear;
    private final int perPixel;

    TileForm(WorkUnits units, int kinds, DisplayCurve display) {
        super(units, kinds);
        this.display = display;
        isLinear = display.encoding() == Color.Encoding.LINEAR;
        perPixel = isLinear ? PER_PIXEL + MEANS_OF_QUARTERS * Float.BYTES : PER_PIXEL;
    }

    @Override
    int longest(int unit) {
        RenderSettings.Crop place = units.place(unit);
        return Math.addExact(Math.multiplyExact(place.width() * place.height(), perPixel), start());
    }

    @Override
    ByteBuffer make(int unit, UnitWork work, ResultHeader header) {
        ByteBuffer out = ByteBuffer.allocate(longest(unit));
        forBlocks(unit, block -> {
            work.part(unit, block);
            header.add(block.surveyRays(), block.hasKnown(), block.lostSamples());
            putBlock(out, units.place(unit), block);
        });
        return out;
    }

    private void forBlocks(int unit, Consumer<FilmTile> what) {
        RenderSettings.Crop place = units.place(unit);
        int side = units.blockSide();
        int bottom = place.y() + place.height();
        for (int y = place.y(); y < bottom; y = Math.min((y / side + 1) * side, bottom)) {
            int height = Math.min((y / side + 1) * side, bottom) - y;
            what.accept(new FilmTile(place.x(), y, place.width(), height, display));
        }
    }

    @Override
    ByteBuffer grow(int unit, UnitWork work, ResultHeader header, byte[] before) {
        RenderSettings.Crop place = units.place(unit);
        if (work.samples(place.x(), place.y()) == 0) {
            return make(unit, work, header);
        }
        ByteBuffer out = ByteBuffer.allocate(longest(unit) + growth(place));
        ByteBuffer old = before == null ? null : ByteBuffer.wrap(before);
        forBlocks(unit, block -> {
            TileGrowth growth = new TileGrowth(block);
            if (old != null) {
                forPixels(
                        place,
                        block,
                        (x, y, pixel) -> growth.read(x, y, samples(old, pixel), old.position(tail(unit, pixel))));
            }
            work.grow(block, growth);
            header.add(0, false, block.lostSamples());
            putBlock(out, place, block);
            forPixels(place, block, (x, y, pixel) -> {
                if (growth.before(x, y) == work.samples(x, y)) {
                    out.put(start() + perPixel * pixel, before, start() + perPixel * pixel, perPixel);
                }
                growth.write(x, y, out.position(tail(unit, pixel)));
            });
        });
        return out;
    }

    @Override
    boolean grows(int unit, UnitWork work, byte[] before) {
        RenderSettings.Crop place = units.place(unit);
        if (before.length != longest(unit) + growth(place)
                || ResultHeader.lostSamples(before, kinds) > 0
                || ResultHeader.samplesAreDifferences(before, kinds)) {
            return false;
        }
        ByteBuffer old = ByteBuffer.wrap(before);
        for (int pixel = 0; pixel < place.width() * place.height(); pixel++) {
            int samples = work.samples(place.x() + pixel % place.width(), place.y() + pixel / place.width());
            if (!TileGrowth.isPossible(samples(old, pixel), samples)) {
                return false;
            }
        }
        return true;
    }

    /** The bytes behind a tile with which it can grow. */
    private static int growth(RenderSettings.Crop place) {
        return Math.multiplyExact(place.width() * place.height(), TileGrowth.BYTES);
    }

    /** The offset of a pixel's growth data. */
    private int tail(int unit, int pixel) {
        return longest(unit) + TileGrowth.BYTES * pixel;
    }

    /** The number of samples of a pixel. */
    private int samples(ByteBuffer result, int pixel) {
        return result.getInt(start() + perPixel * pixel + 3 * Double.BYTES + 2 * Float.BYTES);
    }

    /** Does something for a pixel, by its place in the picture and its number in the tile. */
    @FunctionalInterface
    private interface PixelWork {
        void of(int x, int y, int pixel);
    }

    private static void forPixels(RenderSettings.Crop place, FilmTile block, PixelWork work) {
        for (int y = block.y; y < block.y + block.height; y++) {
            for (int x = block.x; x < block.x + block.width; x++) {
                work.of(x, y, (y - place.y()) * place.width() + x - place.x());
            }
        }
    }

    /** Puts the pixels of a block, in whatever order the blocks come. */
    private void putBlock(ByteBuffer out, RenderSettings.Crop place, FilmTile block) {
        double[] quarters = new double[MEANS_OF_QUARTERS];
        for (int y = block.y; y < block.y + block.height; y++) {
            out.position(start() + perPixel * ((y - place.y()) * place.width() + block.x - place.x()));
            for (int x = block.x; x < block.x + block.width; x++) {
                out.putDouble(block.mean(x, y, 0)).putDouble(block.mean(x, y, 1));
                out.putDouble(block.mean(x, y, 2));
                out.putFloat(block.halves(x, y)).putFloat(block.quarters(x, y)).putInt(block.count(x, y));
                if (isLinear) {
                    block.quarterMeans(x, y, quarters);
                    for (double mean : quarters) {
                        out.putFloat((float) mean);
                    }
                }
            }
        }
    }

    @Override
    Optional<String> problem(int unit, byte[] bytes) {
        RenderSettings.Crop place = units.place(unit);
        boolean canGrow = bytes.length == longest(unit) + growth(place);
        if (bytes.length != longest(unit) && !canGrow) {
            return Optional.of("it has " + bytes.length + " bytes instead of " + longest(unit));
        }
        ByteBuffer in = ByteBuffer.wrap(bytes).position(start());
        for (int pixel = 0; pixel < place.width() * place.height(); pixel++) {
            String wrong = pixelProblem(in);
            if (wrong == null && canGrow) {
                wrong = growthProblem(unit, pixel, ByteBuffer.wrap(bytes)).orElse(null);
            }
            if (wrong != null) {
                return Optional.of("at pixel " + (place.x() + pixel % place.width()) + ","
                        + (place.y() + pixel / place.width()) + " " + wrong);
            }
        }
        return Optional.empty();
    }

    private Optional<String> growthProblem(int unit, int pixel, ByteBuffer in) {
        double[] means = new double[3];
        in.position(start() + perPixel * pixel);
        for (int c = 0; c < 3; c++) {
            means[c] = in.getDouble();
        }
        return TileGrowth.problem(in.position(tail(unit, pixel)), means, samples(in, pixel));
    }

    private String pixelProblem(ByteBuffer in) {
        double brightest = isLinear ? Double.MAX_VALUE : BRIGHTEST;
        for (int c = 0; c < 3; c++) {
            double mean = in.getDouble();
            if (!(Math.abs(mean) <= brightest)) {
                return "a colour is " + mean;
            }
        }
        float halves = in.getFloat();
        if (!(halves >= 0 && halves < Float.POSITIVE_INFINITY)) {
            return "a spread is " + halves;
        }
        float quarters = in.getFloat();
        int samples = in.getInt();
        // Of one or two samples it is a product, which may be negative.
        if (!(Math.abs(quarters) < Float.POSITIVE_INFINITY) || quarters < 0 && samples > 2) {
            return "a spread is " + quarters;
        }
        for (int i = 0; isLinear && i < MEANS_OF_QUARTERS; i++) {
            float mean = in.getFloat();
            if (!(Math.abs(mean) < Float.POSITIVE_INFINITY)) {
                return "the mean of a quarter is " + mean;
            }
        }
        return samples < 1 ? "the number of samples is " + samples : null;
    }

    @Override
    void put(PictureFilm picture, int unit, byte[] bytes) {
        RenderSettings.Crop place = units.place(unit);
        ByteBuffer in = ByteBuffer.wrap(bytes);
        ((TilePicture) picture).tileFilm().put(place.x(), place.y(), place.width(), place.height(), (x, y, pixel) -> {
            in.position(start() + perPixel * ((y - place.y()) * place.width() + x - place.x()));
            for (int c = 0; c < 3; c++) {
                pixel.means[c] = in.getDouble();
            }
            pixel.halves = in.getFloat();
            pixel.quarters = in.getFloat();
            pixel.samples = in.getInt();
            for (int i = 0; isLinear && i < MEANS_OF_QUARTERS; i++) {
                pixel.ofQuarters[i] = in.getFloat();
            }
        });
        picture.mark(unit);
    }

    @Override
    void remove(PictureFilm picture, int unit, ResultStore store) {
        ((TilePicture) picture).blacken(units.place(unit));
        picture.unmark(unit);
    }

    @Override
    boolean needsStore() {
        return false;
    }
}
