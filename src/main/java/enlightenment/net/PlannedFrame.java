package enlightenment.net;

import enlightenment.engine.DividedRender;
import enlightenment.engine.FilmAssembly;
import enlightenment.engine.RenderCourse;
import enlightenment.engine.RenderOutline;
import enlightenment.engine.ResultCheck;
import enlightenment.engine.UnitGroups;
import enlightenment.net.server.FrameAssemblies;
import enlightenment.scene.RenderSettings;
import java.util.List;

/**
 * The plan of a frame, and its share of the film's resources.
 *
 * @param outline what is rendered
 * @param course its render
 * @param pixels number of its pixels
 * @param ahead how many frames like it may be worked at at once
 * @param group how many of its tiles are one of the film
 */
record PlannedFrame(RenderOutline outline, RenderCourse course, long pixels, int ahead, int group) {
    /** Share of the maximal heap that the frames in progress may take. */
    private static final double SHARE_OF_MEMORY = 0.25;

    /** Upper bound of the bytes of a pixel in progress: sums of paths and of tiles, and the finished picture. */
    private static final int BYTES_PER_PIXEL = 256;

    /** Least number of tiles of the frames in progress, if they have as many: a hundred machines get dozens each. */
    private static final int FEWEST_TILES = 1 << 12;

    /** Largest number of camera rays of a film's tile that has several of the picture's: half a second of a processor. */
    private static final double MOST_RAYS = 1 << 21;

    /** Largest number of pixels of such a tile: its result stays below a megabyte. */
    private static final int MOST_PIXELS = 1 << 13;

    /** @param frames of the film */
    static PlannedFrame of(DividedRender render, int frames) {
        RenderOutline outline = render.outline();
        RenderSettings.Crop region = outline.settings().region();
        long pixels = (long) region.width() * region.height();
        double memory = SHARE_OF_MEMORY * Runtime.getRuntime().maxMemory();
        // Two at least, so that workers have tiles of the next frame while one ends.
        int ahead = (int) Math.max(2, Math.min(memory / ((double) pixels * BYTES_PER_PIXEL), frames));
        double pixelsOfTile = (double) pixels / render.units();
        double raysOfTile = pixelsOfTile * Math.max(outline.plan().samples(), 1);
        double most = Math.min(MOST_RAYS / raysOfTile, MOST_PIXELS / pixelsOfTile);
        double group = Math.min((double) ahead * render.units() / FEWEST_TILES, most);
        return new PlannedFrame(outline, render.course(), pixels, ahead, (int) Math.max(1, group));
    }

    /** The frames of a film as its assemblies need them. */
    record All(List<PlannedFrame> frames) implements FrameAssemblies.Frames {
        @Override
        public long pixels(int frame) {
            return frames.get(frame).pixels;
        }

        @Override
        public UnitGroups groups(int frame) {
            return UnitGroups.of(frames.get(frame).outline, frames.get(frame).group);
        }

        @Override
        public ResultCheck check(int frame) {
            return ResultCheck.of(frames.get(frame).outline);
        }

        @Override
        public FilmAssembly empty(int frame) {
            return frames.get(frame).course.assembly(true);
        }
    }
}
