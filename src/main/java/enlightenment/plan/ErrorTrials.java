package enlightenment.plan;

import enlightenment.film.ErrorEstimate;
import enlightenment.film.FilmTile;
import enlightenment.picture.Rounding;
import enlightenment.scene.RenderSettings;
import java.util.ArrayList;
import java.util.List;
import java.util.function.BooleanSupplier;

/**
 * Finds out by trials how many samples per pixel an error takes. What is sought is the number for which the upper end of the
 * interval that the finished picture will give itself is as asked, rounding included. All trials together take at most about half
 * of what the render will, unless the picture is small: what they miss, the finished picture tells ({@link Rounds}).
 */
final class ErrorTrials {
    /** A trial renders a sixteenth of the blocks, or {@link #LEAST_BLOCKS} of them if that is more, but at most an eighth. */
    private static final double SHARE = 1.0 / 16;

    private static final double MOST_SHARE = 1.0 / 8;
    private static final double LEAST_BLOCKS = 320;

    /** Least number of blocks in the sample of an eighth: fewer do not represent the others. */
    private static final double TOO_FEW_BLOCKS = 16;

    /** Target of the trials as a share of the error asked for: a trial covers only some of the picture. */
    private static final double AIM = 0.97;

    /** {@link #AIM} where no round follows: the picture's own noise must not push its error beyond what is asked. */
    private static final double LAST_AIM = 0.9;

    private static final int MOST_TRIALS = 7;

    /** The cost of all trials, as a share of the render that they propose. */
    private static final double MOST_COST = 0.5;

    /** Rounding that takes this share of the error leaves nothing that could be reached. */
    private static final double HOPELESS = 0.99;

    /** Renders blocks with a number of samples per pixel. */
    @FunctionalInterface
    interface Sampler {
        void render(double samples, List<FilmTile> blocks);
    }

    private final double asked;
    private final int depth;
    private final Sampler sampler;
    private final BooleanSupplier stop;
    private final TrialBlocks blocks;
    private final double share;

    /** Whether no picture follows that could make up for what trials miss. */
    private final boolean isLast;

    /** The cost of the trials, in samples per pixel of the whole render. */
    private double work;

    private double rounding;

    /** The trial that the present answer comes from. */
    private List<FilmTile> answered;

    /**
     * @param blocks of the same settings
     * @param stop once true, nothing more is tried
     * @param isLast whether no round follows the picture that is planned: what is too small for trials of some blocks is tried as a whole
     */
    ErrorTrials(RenderSettings settings, TrialBlocks blocks, Sampler sampler, BooleanSupplier stop, boolean isLast) {
        asked = settings.budget().error().orElseThrow();
        depth = settings.budget().depth();
        this.sampler = sampler;
        this.stop = stop;
        this.blocks = blocks;
        this.isLast = isLast;
        share = isLast && isSmall() ? 1 : Math.max(SHARE, Math.min(MOST_SHARE, LEAST_BLOCKS / blocks.count()));
    }

    private boolean isSmall() {
        return blocks.count() * MOST_SHARE < TOO_FEW_BLOCKS;
    }

    /** Whether what is rendered is so small that trials tell nothing: then the picture itself is the cheapest trial, if others follow. */
    boolean areTooFew() {
        return isSmall() && !isLast;
    }

    /** Whether rounding alone makes the error as large as it may be; known after a search, or after {@link #findRounding}. */
    boolean isHopeless() {
        return rounding >= HOPELESS * asked;
    }

    /** The root mean square of what rounding to the file's depth changes, as far as trials tell. */
    double rounding() {
        return rounding;
    }

    /** Finds what rounding changes, by one sample of each pixel of all blocks. */
    void findRounding() {
        List<FilmTile> tiles = trial(1, 0, 1);
        rounding = stop.getAsBoolean() ? 0 : Math.sqrt(squaredRounding(tiles));
    }

    /** The cost of all trials, in samples per pixel of the whole render. */
    double work() {
        return work;
    }

    /**
     * The number of samples for which the error is as asked, if it lies between {@code least} and {@code most}; if not, the latter.
     *
     * @param first the number to begin with
     * @param planning what it costs to plan for another number, beside the trial, in samples per pixel of the whole render
     * @return infinite where even the largest number seems not to be enough, or it was stopped before it could be known
     */
    double search(double least, double first, double most, double planning) {
        ErrorSearch search = new ErrorSearch(asked, least, most);
        double n = Math.min(Math.max(first, least), most);
        for (int k = 0; k < MOST_TRIALS; k++) {
            work += planning;
            List<FilmTile> tiles = trial(n, 0, share);
            double e = stop.getAsBoolean() ? 0 : figure(tiles);
            if (stop.getAsBoolean() || isHopeless()) {
                return Double.POSITIVE_INFINITY;
            }
            search.found(n, e);
            answered = search.answer() == n ? tiles : answered;
            if (search.isOver()) {
                break;
            }
            n = Math.min(Math.max(Tidy.of(search.next()), least), most);
            if (share < 1 && work + planning + share * n > MOST_COST * n) {
                return search.isFound() ? search.answer() : n < most ? n : Double.POSITIVE_INFINITY;
            }
        }
        if (!search.isFound()) {
            return search.answer() < most ? Tidy.of(search.answer()) : Double.POSITIVE_INFINITY;
        }
        return share < 1 ? confirmed(search.answer(), most) : search.answer();
    }

    /** The answer, or more where twice as many blocks say so. */
    private double confirmed(double n, double most) {
        List<FilmTile> both = new ArrayList<>(answered);
        both.addAll(trial(n, 1, share));
        if (stop.getAsBoolean()) {
            return n;
        }
        double e = figure(both);
        if (isHopeless()) {
            return Double.POSITIVE_INFINITY;
        }
        double more = e <= asked ? n : Tidy.of(n * StrictMath.pow(e / asked, 1 / ErrorSearch.USUAL_SLOPE));
        return more <= most ? more : Double.POSITIVE_INFINITY;
    }

    private List<FilmTile> trial(double samples, int phase, double ofBlocks) {
        List<FilmTile> tiles = blocks.phase(phase, ofBlocks);
        sampler.render(samples, tiles);
        work += samples * tiles.size() / blocks.count();
        return tiles;
    }

    /**
     * The figure that is compared with the error asked for. Its interval lies between that of the trial, which allows for what it may have
     * missed, and that of a whole picture like it, which has less noise.
     */
    private double figure(List<FilmTile> tiles) {
        double square = squaredRounding(tiles);
        rounding = Math.sqrt(square);
        if (isHopeless()) {
            return Double.POSITIVE_INFINITY;
        }
        List<FilmTile> whole = new ArrayList<>();
        for (long k = Math.max(blocks.count() / tiles.size(), 1); k > 0; k--) {
            whole.addAll(tiles);
        }
        double high = Math.sqrt(
                ErrorEstimate.of(tiles).high() * ErrorEstimate.of(whole).high());
        return high / (isLast ? LAST_AIM : AIM) * asked / Math.sqrt(asked * asked - square);
    }

    private double squaredRounding(List<FilmTile> tiles) {
        double sum = 0;
        long components = 0;
        for (FilmTile tile : tiles) {
            for (int y = tile.y; y < tile.y + tile.height; y++) {
                for (int x = tile.x; x < tile.x + tile.width; x++) {
                    for (int c = 0; c < 3; c++) {
                        sum += Rounding.square((float) tile.displayed(x, y, c), depth);
                    }
                    components += 3;
                }
            }
        }
        return sum / components;
    }
}
