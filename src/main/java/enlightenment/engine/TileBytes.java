package enlightenment.engine;

import enlightenment.compiled.RayCounters;
import enlightenment.film.Film;
import enlightenment.film.FilmTile;
import enlightenment.scene.RenderSettings;
import java.nio.ByteBuffer;
import java.util.Optional;

/**
 * A tile as bytes, most significant first: the number of survey rays, the counters, and 1 if samples are differences from
 * something known, else 0 (8 bytes each); then for each pixel, row by row, the means of red, green and blue (8 bytes each), the
 * two figures that tell of its error (4 each) and the number of its samples (4).
 */
final class TileBytes {
    private static final int SCALARS = 12;
    private static final int PER_PIXEL = 3 * Double.BYTES + 2 * Float.BYTES + Integer.BYTES;

    /** Display-referred means lie near 0..1; brighter light than this is a fault, not light. */
    private static final double BRIGHTEST = 1 << 20;

    private TileBytes() {}

    /** Length of a tile with this many pixels in a scene with this many kinds of primitives. */
    static int length(int pixels, int kinds) {
        return Math.addExact(Math.multiplyExact(pixels, PER_PIXEL), (SCALARS + 2 * kinds) * Long.BYTES);
    }

    static void putHeader(ByteBuffer out, RayCounters c, long surveyRays, boolean differences) {
        out.putLong(surveyRays)
                .putLong(c.cameraRays)
                .putLong(c.mirrorRays)
                .putLong(c.refractedRays)
                .putLong(c.shadowRays);
        out.putLong(c.lightSamples).putLong(c.lightSamplesWithoutRay).putLong(c.textureLookups);
        out.putLong(c.proposals).putLong(c.accepted).putLong(c.clusters);
        for (int i = 0; i < c.tests.length; i++) {
            out.putLong(c.tests[i]).putLong(c.hits[i]);
        }
        out.putLong(differences ? 1 : 0);
    }

    /** Reads the counters; the number of survey rays is the first number of the tile. */
    static RayCounters counters(byte[] tile, int kinds) {
        ByteBuffer in = ByteBuffer.wrap(tile).position(Long.BYTES);
        RayCounters c = new RayCounters(kinds);
        c.cameraRays = in.getLong();
        c.mirrorRays = in.getLong();
        c.refractedRays = in.getLong();
        c.shadowRays = in.getLong();
        c.lightSamples = in.getLong();
        c.lightSamplesWithoutRay = in.getLong();
        c.textureLookups = in.getLong();
        c.proposals = in.getLong();
        c.accepted = in.getLong();
        c.clusters = in.getLong();
        for (int i = 0; i < kinds; i++) {
            c.tests[i] = in.getLong();
            c.hits[i] = in.getLong();
        }
        return c;
    }

    static long surveyRays(byte[] tile) {
        return ByteBuffer.wrap(tile).getLong();
    }

    /** Puts the pixels of a block, in whatever order the blocks come. */
    static void putBlock(ByteBuffer out, int kinds, RenderSettings.Crop place, FilmTile block) {
        for (int y = block.y; y < block.y + block.height; y++) {
            out.position(length((y - place.y()) * place.width() + block.x - place.x(), kinds));
            for (int x = block.x; x < block.x + block.width; x++) {
                out.putDouble(block.mean(x, y, 0)).putDouble(block.mean(x, y, 1));
                out.putDouble(block.mean(x, y, 2));
                out.putFloat(block.halves(x, y)).putFloat(block.quarters(x, y)).putInt(block.count(x, y));
            }
        }
    }

    /** Why these bytes cannot be the tile; empty if they can. */
    static Optional<String> problem(byte[] tile, RenderSettings.Crop place, int kinds) {
        int pixels = place.width() * place.height();
        if (tile.length != length(pixels, kinds)) {
            return Optional.of("it has " + tile.length + " bytes instead of " + length(pixels, kinds));
        }
        ByteBuffer in = ByteBuffer.wrap(tile);
        for (int i = 0; i < SCALARS + 2 * kinds; i++) {
            if (in.getLong() < 0) {
                return Optional.of("a counter is negative");
            }
        }
        for (int pixel = 0; pixel < pixels; pixel++) {
            String wrong = pixelProblem(in);
            if (wrong != null) {
                return Optional.of("at pixel " + (place.x() + pixel % place.width()) + ","
                        + (place.y() + pixel / place.width()) + " " + wrong);
            }
        }
        return Optional.empty();
    }

    private static String pixelProblem(ByteBuffer in) {
        for (int c = 0; c < 3; c++) {
            double mean = in.getDouble();
            if (!(Math.abs(mean) <= BRIGHTEST)) {
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
        return samples < 1 ? "the number of samples is " + samples : null;
    }

    /** Whether the samples of a tile are differences from something known. */
    static boolean samplesAreDifferences(byte[] tile, int kinds) {
        return ByteBuffer.wrap(tile).getLong(length(0, kinds) - Long.BYTES) != 0;
    }

    /** Puts a tile that has no problem into the film; null takes it out. */
    static void into(Film film, byte[] tile, RenderSettings.Crop place, int kinds) {
        ByteBuffer in = tile == null ? null : ByteBuffer.wrap(tile).position(length(0, kinds));
        double[] means = new double[3];
        for (int y = place.y(); y < place.y() + place.height(); y++) {
            for (int x = place.x(); x < place.x() + place.width(); x++) {
                if (in == null) {
                    film.put(x, y, means, 0, 0, 0, 0);
                    continue;
                }
                for (int c = 0; c < 3; c++) {
                    means[c] = in.getDouble();
                }
                film.put(x, y, means, 0, in.getFloat(), in.getFloat(), in.getInt());
            }
        }
    }
}
