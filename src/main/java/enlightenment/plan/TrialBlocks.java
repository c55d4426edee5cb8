package enlightenment.plan;

import enlightenment.color.DisplayCurve;
import enlightenment.film.FilmTile;
import enlightenment.method.SpreadPlaces;
import enlightenment.method.cluster.SeenBlocks;
import enlightenment.sampling.Hash;
import enlightenment.scene.RenderSettings;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.function.Predicate;

/**
 * The blocks that trials are made of: of what is rendered, the whole picture or the part of it that was asked for, a share that
 * is spread evenly. Which blocks they are changes with the seed, so that a small thing that is between them in one picture is not
 * so in all of them; and each phase has other blocks than the phase before, so that two of them together are twice as dense.
 */
final class TrialBlocks {
    /** Keeps the choice of the blocks apart from all other random numbers. */
    private static final long PURPOSE = 0x626c6f636b73L;

    private final RenderSettings.Crop area;
    private final int left;
    private final int top;
    private final int across;
    private final int down;
    private final double first;
    private final int side;

    private final DisplayCurve display;

    /**
     * @param display what pixels are, and how they become what a screen takes
     * @param blockSide of {@link MethodTraits}
     */
    TrialBlocks(RenderSettings settings, DisplayCurve display, int blockSide) {
        side = blockSide;
        this.display = display;
        area = settings.region();
        left = area.x() / side;
        top = area.y() / side;
        across = (area.x() + area.width() - 1) / side - left + 1;
        down = (area.y() + area.height() - 1) / side - top + 1;
        first = Hash.unit(Hash.of(settings.seed(), PURPOSE));
    }

    /** The number of blocks in all. */
    long count() {
        return (long) across * down;
    }

    /** The blocks of a phase, without samples yet; at least one. */
    List<FilmTile> phase(int phase, double share) {
        double from = first + phase * share;
        List<int[]> places = SpreadPlaces.of(across, down, from - Math.floor(from), share);
        if (places.isEmpty()) {
            places.add(new int[] {across / 2, down / 2});
        }
        List<FilmTile> blocks = new ArrayList<>();
        for (int[] place : places) {
            blocks.add(block(left + place[0], top + place[1]));
        }
        return blocks;
    }

    /**
     * Blocks of the first phase that show something, and the share of all blocks that these are chosen from; where nothing does, the first
     * phase.
     *
     * @param ofPicture how many of the blocks that show something, as a share of all blocks; or all of them, if that is less
     * @param seen whether a rectangle of pixels may show something
     */
    Seen seen(double ofPicture, Predicate<RenderSettings.Crop> seen) {
        double range = Math.min((double) SeenBlocks.MOST_LOOKED_AT / count(), 1);
        List<int[]> lookedAt = SpreadPlaces.of(across, down, first, range);
        lookedAt.removeIf(place -> !seen.test(area(left + place[0], top + place[1])));
        Set<Long> found = new HashSet<>();
        lookedAt.forEach(place -> found.add(number(place)));
        if (lookedAt.isEmpty()) {
            return new Seen(phase(0, ofPicture), 1);
        }
        double share = lookedAt.size() / (range * count());
        List<FilmTile> blocks = new ArrayList<>();
        double threshold = Math.min(ofPicture / Math.min(share, 1), range);
        // All of these have been looked at: they begin at the same place, and end no later.
        for (int[] place : SpreadPlaces.of(across, down, first, threshold)) {
            if (found.contains(number(place))) {
                blocks.add(block(left + place[0], top + place[1]));
            }
        }
        if (blocks.isEmpty()) {
            blocks.add(block(left + lookedAt.get(0)[0], top + lookedAt.get(0)[1]));
        }
        return new Seen(blocks, Math.min(share, 1));
    }

    private long number(int[] place) {
        return (long) place[1] * across + place[0];
    }

    /** Blocks that show something, and the share of such blocks among all. */
    record Seen(List<FilmTile> blocks, double share) {}

    private RenderSettings.Crop area(int column, int row) {
        return area.intersection(new RenderSettings.Crop(column * side, row * side, side, side));
    }

    private FilmTile block(int column, int row) {
        RenderSettings.Crop c = area(column, row);
        return new FilmTile(c.x(), c.y(), c.width(), c.height(), display);
    }
}
