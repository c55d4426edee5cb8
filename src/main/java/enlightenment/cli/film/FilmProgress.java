package enlightenment.cli.film;

import enlightenment.image.Image;
import enlightenment.render.RenderProgress;
import java.util.function.Supplier;

/** Converts the progress of frames into that of a whole film. */
final class FilmProgress implements RenderProgress {
    private final RenderProgress display;
    private final int frames;
    private int finished;

    /** The length of a frame: the pixels of the first. */
    private long length;

    /** Pixels of the current frame that are done; a further round does not lower it. */
    private long ofFrame;

    /**
     * @param display receives progress in pixels of the film
     * @param frames how many will be rendered
     */
    FilmProgress(RenderProgress display, int frames) {
        this.display = display;
        this.frames = frames;
    }

    @Override
    public void coarse(Supplier<Image> soFar) {
        display.coarse(soFar);
    }

    @Override
    public void progress(long done, long total, Supplier<Image> soFar) {
        length = length == 0 ? total : length;
        ofFrame = Math.max(ofFrame, (long) ((double) done / total * length));
        display.progress(finished * length + ofFrame, frames * length, soFar);
    }

    /** The frame is there. */
    void frameFinished() {
        finished++;
        ofFrame = 0;
    }
}
