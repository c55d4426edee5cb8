package enlightenment.plan;

import enlightenment.color.DisplayCurve;
import enlightenment.film.FilmTile;
import enlightenment.method.SpreadPlaces;
import enlightenment.sampling.Hash;
import enlightenment.scene.RenderSettings;
import java.util.ArrayList;
import java.util.List;

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

    /** How many blocks there are in all. */
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

    private FilmTile block(int column, int row) {
        RenderSettings.Crop c = area.intersection(new RenderSettings.Crop(column * side, row * side, side, side));
        return new FilmTile(c.x(), c.y(), c.width(), c.height(), display);
    }
}
