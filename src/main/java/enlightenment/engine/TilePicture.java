package enlightenment.engine;

import enlightenment.film.ErrorEstimate;
import enlightenment.film.Film;
import enlightenment.film.FilmInFile;
import enlightenment.film.FilmTile;
import enlightenment.film.TileFilm;
import enlightenment.film.TilePasses;
import enlightenment.image.Image;
import enlightenment.scene.RenderSettings;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** A picture of which each pixel belongs to one tile. */
public final class TilePicture extends PictureFilm {
    private final TileFilm film;

    /** Tiles of which passes are there, where there are several. */
    private final Map<Integer, TilePasses> passes = new HashMap<>();

    /** Whether finished tiles can be taken apart again. */
    private final boolean isKept;

    private long pixelPasses;
    private long finished;

    /**
     * A picture of which nothing is there yet.
     *
     * @param isKept whether passes can be taken out again: that takes six times the memory
     * @param place where the finished pixels are
     */
    TilePicture(WorkUnits units, RenderOutline outline, boolean isKept, FilmPlace place) {
        super(units, outline);
        this.isKept = isKept;
        film = place.folder().isPresent()
                ? new FilmInFile(
                        region.x(),
                        region.y(),
                        region.width(),
                        region.height(),
                        outline.display(),
                        place.folder().get())
                : new Film(region.x(), region.y(), region.width(), region.height(), outline.display());
    }

    /** The finished pixels. */
    TileFilm tileFilm() {
        return film;
    }

    /**
     * The finished pixels.
     *
     * @throws ClassCastException if they are not in memory
     */
    public Film film() {
        return (Film) film;
    }

    @Override
    public void release() {
        film.release();
    }

    @Override
    public FilmTile render(int unit, UnitWork work) {
        FilmTile tile = work.tile(unit);
        if (units.passes() > 1) {
            return putPass(unit, tile);
        }
        film.put(tile);
        mark(unit);
        return tile;
    }

    /** Puts a pass, which must not be there; returns the tile that is finished by this, or null. */
    FilmTile putPass(int unit, FilmTile pass) {
        int tile = units.tile(unit);
        FilmTile whole = null;
        synchronized (this) {
            TilePasses all = passes.computeIfAbsent(tile, t -> passesOf(pass));
            all.add(units.pass(unit), pass);
            if (all.missing() == 0) {
                whole = pass.like(pass.x, pass.y, pass.width, pass.height);
                all.into(whole);
                film.put(whole);
                if (!isKept) {
                    passes.remove(tile);
                }
            }
            mark(unit);
        }
        return whole;
    }

    private TilePasses passesOf(FilmTile tile) {
        return new TilePasses(tile.x, tile.y, tile.width, tile.height, units.passes());
    }

    /**
     * Removes a pass that is present.
     *
     * @return the units that were added up with it and are gone, too
     */
    synchronized List<Integer> removePass(int unit) {
        RenderSettings.Crop place = units.place(unit);
        int first = unit - units.pass(unit);
        blacken(place);
        List<Integer> lost = passes.get(units.tile(unit)).remove(units.pass(unit)).stream()
                .map(pass -> first + pass)
                .toList();
        lost.forEach(this::unmark);
        return lost.stream().filter(u -> u != unit).toList();
    }

    /** Leaves nothing of the finished pixels of a tile. */
    void blacken(RenderSettings.Crop place) {
        film.clear(place.x(), place.y(), place.width(), place.height());
    }

    @Override
    void count(int unit, int by) {
        RenderSettings.Crop place = units.place(unit);
        long pixels = (long) place.width() * place.height();
        pixelPasses += by * pixels;
        int first = unit - units.pass(unit);
        int there = 0;
        for (int pass = 0; pass < units.passes(); pass++) {
            there += has(first + pass) ? 1 : 0;
        }
        // The pass that makes it whole, or the first that is missing again.
        finished += there == units.passes() + (by - 1) / 2 ? by * pixels : 0;
    }

    @Override
    public synchronized long pixelsDone() {
        return pixelPasses / units.passes();
    }

    @Override
    public synchronized long finishedPixels() {
        return finished;
    }

    @Override
    public long shownPixels() {
        return finishedPixels();
    }

    @Override
    public long cameraSamples() {
        return film.cameraSamples();
    }

    @Override
    public int samples(int column, int row) {
        return film.count(column, row);
    }

    @Override
    public float[] quarterMeans() {
        return film.quarterMeans();
    }

    @Override
    public ErrorEstimate error() {
        return film.error();
    }

    @Override
    void samplesAreDifferences(boolean are) {
        film.samplesAreDifferences(are);
    }

    @Override
    void samplesAreLost(long number) {
        film.samplesAreLost(number);
    }

    @Override
    public long lostSamples() {
        return film.lostSamples();
    }

    @Override
    public Image image() {
        return film.toImage();
    }

    @Override
    public Image shown() {
        return film.shown();
    }
}
