package enlightenment.engine;

import enlightenment.film.ErrorEstimate;
import enlightenment.film.FilmTile;
import enlightenment.film.TileFilm;
import enlightenment.image.Image;
import enlightenment.plan.Integrators;

/** The sum of two pictures: of tiles, and of paths that may end anywhere. What the paths bring is part of all finished pixels. */
final class MixedPicture extends PictureFilm {
    private final TilePicture tiles;
    private final SplatPicture splats;
    private final RenderOutline outline;

    /** Whose share of the work the tiles are. */
    private final double shareOfTiles;

    private final boolean isInMemory;

    /** The sum of complete parts, or of parts in files, since both image and error are asked of it; null before. */
    private TileFilm total;

    /** The number of changes of the parts when the sum was made. */
    private long totalOf;

    MixedPicture(WorkUnits units, TilePicture tiles, SplatPicture splats, RenderOutline outline, FilmPlace place) {
        super(units, outline);
        isInMemory = place.folder().isEmpty();
        this.tiles = tiles;
        this.splats = splats;
        this.outline = outline;
        double samples = outline.plan().samples()
                * outline.settings().width()
                * outline.settings().height();
        shareOfTiles = samples
                / (samples + Integrators.weightOfLightPath(outline.plan().method()) * units.paths());
    }

    @Override
    PictureFilm part(int unit) {
        return units.isBatch(unit) ? splats : tiles;
    }

    @Override
    public FilmTile render(int unit, UnitWork work) {
        return part(unit).render(unit, work);
    }

    @Override
    void count(int unit, int by) {
        throw new IllegalStateException("the parts count");
    }

    @Override
    public boolean has(int unit) {
        return part(unit).has(unit);
    }

    @Override
    public int done() {
        return tiles.done() + splats.done();
    }

    @Override
    public long pixelsDone() {
        double share = shareOfTiles * tiles.pixelsDone() / pixels() + (1 - shareOfTiles) * splats.share();
        return isComplete() ? pixels() : Math.min((long) (pixels() * share), pixels() - 1);
    }

    @Override
    public long finishedPixels() {
        return tiles.finishedPixels();
    }

    @Override
    public long shownPixels() {
        return tiles.shownPixels();
    }

    @Override
    public long cameraSamples() {
        return tiles.cameraSamples();
    }

    @Override
    public int samples(int column, int row) {
        return tiles.samples(column, row);
    }

    @Override
    synchronized void samplesAreDifferences(boolean are) {
        forgetTotal();
        tiles.samplesAreDifferences(are);
    }

    @Override
    synchronized void samplesAreLost(long number) {
        forgetTotal();
        tiles.samplesAreLost(number);
    }

    @Override
    public long lostSamples() {
        return tiles.lostSamples();
    }

    @Override
    public float[] quarterMeans() {
        return sum().quarterMeans();
    }

    @Override
    public ErrorEstimate error() {
        return sum().error();
    }

    @Override
    public Image image() {
        return sum().toImage();
    }

    /** The sum as far as it is computed. Otherwise the tiles alone, as films in files are added only for the finished picture. */
    @Override
    public synchronized Image shown() {
        if (isInMemory) {
            return image();
        }
        return isTotal() ? total.shown() : tiles.shown();
    }

    private boolean isTotal() {
        return total != null && totalOf == tiles.changes() + splats.changes();
    }

    private synchronized TileFilm sum() {
        if (isTotal()) {
            return total;
        }
        forgetTotal();
        long changes = tiles.changes() + splats.changes();
        boolean isLast = isComplete();
        TileFilm sum = tiles.tileFilm().plus(splats.splats());
        total = isLast || !isInMemory ? sum : null;
        totalOf = changes;
        return sum;
    }

    private void forgetTotal() {
        if (total != null) {
            total.release();
            total = null;
        }
    }

    @Override
    public synchronized void release() {
        forgetTotal();
        tiles.release();
        splats.release();
    }

    @Override
    public Image completed(Image image) {
        float[] rgb = image.toArray();
        splats.film().addTo(rgb);
        return new Image(image.width(), image.height(), rgb, outline.display());
    }
}
