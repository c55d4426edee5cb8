package enlightenment.engine;

import enlightenment.color.Color;
import enlightenment.color.DisplayCurve;
import enlightenment.film.FilmTile;
import enlightenment.scene.RenderSettings;
import java.nio.ByteBuffer;
import java.util.Optional;

/**
 * A pass over a tile: for each pixel, row by row, the sums of red, green and blue and what the rounding of each has lost (8 bytes
 * each), and the number of its samples (4).
 */
final class PassForm extends ResultForm {
    private static final int NUMBERS = 6;
    private static final int PER_PIXEL = NUMBERS * Double.BYTES + Integer.BYTES;

    private final DisplayCurve display;

    /** The greatest mean of samples that is taken for light. */
    private final double brightest;

    PassForm(WorkUnits units, int kinds, DisplayCurve display) {
        super(units, kinds);
        this.display = display;
        brightest = display.encoding() == Color.Encoding.LINEAR ? Double.MAX_VALUE : TileForm.BRIGHTEST;
    }

    @Override
    int longest(int unit) {
        RenderSettings.Crop place = units.place(unit);
        return Math.addExact(Math.multiplyExact(place.width() * place.height(), PER_PIXEL), start());
    }

    @Override
    ByteBuffer make(int unit, UnitWork work, ResultHeader header) {
        FilmTile tile = work.tile(unit);
        header.add(tile.surveyRays(), tile.hasKnown(), tile.lostSamples());
        ByteBuffer out = ByteBuffer.allocate(longest(unit)).position(start());
        for (int y = tile.y; y < tile.y + tile.height; y++) {
            for (int x = tile.x; x < tile.x + tile.width; x++) {
                for (int c = 0; c < 3; c++) {
                    out.putDouble(tile.sum(x, y, c)).putDouble(tile.compensation(x, y, c));
                }
                out.putInt(tile.count(x, y));
            }
        }
        return out;
    }

    @Override
    Optional<String> problem(int unit, byte[] bytes) {
        if (bytes.length != longest(unit)) {
            return Optional.of("it has " + bytes.length + " bytes instead of " + longest(unit));
        }
        RenderSettings.Crop place = units.place(unit);
        ByteBuffer in = ByteBuffer.wrap(bytes).position(start());
        double[] sums = new double[NUMBERS];
        for (int pixel = 0; pixel < place.width() * place.height(); pixel++) {
            for (int i = 0; i < NUMBERS; i++) {
                sums[i] = in.getDouble();
            }
            int samples = in.getInt();
            for (double sum : sums) {
                if (samples < 1
                        || samples > Integer.MAX_VALUE / units.passes()
                        || !(Math.abs(sum) <= Math.min(brightest * samples, Double.MAX_VALUE))) {
                    return Optional.of("at pixel " + (place.x() + pixel % place.width()) + ","
                            + (place.y() + pixel / place.width()) + " a sum of " + samples + " samples is " + sum);
                }
            }
        }
        return Optional.empty();
    }

    @Override
    void put(PictureFilm picture, int unit, byte[] bytes) {
        RenderSettings.Crop place = units.place(unit);
        FilmTile pass = new FilmTile(place.x(), place.y(), place.width(), place.height(), display);
        ByteBuffer in = ByteBuffer.wrap(bytes).position(start());
        double[] sums = new double[NUMBERS];
        for (int y = place.y(); y < place.y() + place.height(); y++) {
            for (int x = place.x(); x < place.x() + place.width(); x++) {
                for (int i = 0; i < NUMBERS; i++) {
                    sums[i] = in.getDouble();
                }
                pass.put(x, y, sums, 0, in.getInt());
            }
        }
        ((TilePicture) picture).putPass(unit, pass);
    }

    @Override
    void remove(PictureFilm picture, int unit, ResultStore store) {
        for (int other : ((TilePicture) picture).removePass(unit)) {
            put(picture, other, store.get(other));
        }
    }

    @Override
    boolean needsStore() {
        return true;
    }
}
