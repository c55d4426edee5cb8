package enlightenment.engine;

import enlightenment.film.ErrorEstimate;
import enlightenment.film.FilmTile;
import enlightenment.film.SplatFilm;
import enlightenment.film.SplatFilmInFile;
import enlightenment.film.SplatSums;
import enlightenment.film.Splats;
import enlightenment.image.Image;
import enlightenment.scene.RenderSettings;

/** A picture that each batch of paths adds something to everywhere: all of its pixels get finished together. */
final class SplatPicture extends PictureFilm {
    private final Splats film;
    private final long picturePixels;
    private int batches;

    /** @param place where the sums are; of a picture of such paths alone in memory */
    SplatPicture(WorkUnits units, RenderOutline outline, FilmPlace place) {
        super(units, outline);
        RenderSettings settings = outline.settings();
        picturePixels = (long) settings.width() * settings.height();
        film = place.folder().isEmpty()
                ? new SplatFilm(
                        region.x(),
                        region.y(),
                        region.width(),
                        region.height(),
                        picturePixels,
                        outline.splatScale(),
                        outline.display())
                : new SplatFilmInFile(
                        region.x(),
                        region.y(),
                        region.width(),
                        region.height(),
                        picturePixels,
                        outline.splatScale(),
                        outline.display(),
                        place.folder().get());
    }

    /** The sums of the batches so far. */
    Splats splats() {
        return film;
    }

    /**
     * The sums of the batches so far, in memory.
     *
     * @throws ClassCastException if it is in a file
     */
    SplatFilm film() {
        return (SplatFilm) film;
    }

    @Override
    public void release() {
        film.release();
    }

    /** The share of the batches that is there. */
    synchronized double share() {
        return (double) batches / units.batches();
    }

    @Override
    public FilmTile render(int unit, UnitWork work) {
        put(unit, work.batch(unit));
        return null;
    }

    /** Puts a batch, which must not be there. */
    void put(int unit, SplatSums batch) {
        film.add(unit, batch);
        mark(unit);
    }

    /** Removes a batch that is present, with these sums. */
    void remove(int unit, SplatSums batch) {
        film.remove(unit, batch);
        unmark(unit);
    }

    @Override
    void count(int unit, int by) {
        batches += by;
    }

    @Override
    public synchronized long pixelsDone() {
        return (long) ((double) pixels() * batches / units.batches());
    }

    @Override
    public long finishedPixels() {
        return pixelsDone();
    }

    @Override
    public synchronized long shownPixels() {
        return batches == 0 ? 0 : pixels();
    }

    /** The paths of the pixels that are rendered: of a crop, its share of all. */
    @Override
    public long cameraSamples() {
        return (long) ((double) film.paths() * pixels() / picturePixels);
    }

    @Override
    public int samples(int column, int row) {
        return (int) Math.min(film.paths() / picturePixels, Integer.MAX_VALUE);
    }

    @Override
    public float[] quarterMeans() {
        return film().quarterMeans();
    }

    @Override
    public ErrorEstimate error() {
        return film().error();
    }

    @Override
    public Image image() {
        return film().toImage();
    }
}
