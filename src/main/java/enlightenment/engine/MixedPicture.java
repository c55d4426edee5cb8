package enlightenment.engine;

import enlightenment.film.ErrorEstimate;
import enlightenment.film.Film;
import enlightenment.film.FilmTile;
import enlightenment.film.FloatLight;
import enlightenment.film.SplatFilm;
import enlightenment.image.Image;
import enlightenment.plan.Integrators;

/** The sum of two pictures: of tiles, and of paths that may end anywhere. What the paths bring is part of all finished pixels. */
final class MixedPicture extends PictureFilm {
    private final TilePicture tiles;
    private final SplatPicture splats;
    private final RenderOutline outline;

    /** Whose share of the work the tiles are. */
    private final double shareOfTiles;

    /** The sum of complete parts, since both image and error are asked of it; null before. */
    private Film total;

    /** How often the parts had changed when it was made. */
    private long totalOf;

    MixedPicture(WorkUnits units, TilePicture tiles, SplatPicture splats, RenderOutline outline) {
        super(units, outline);
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
        total = null;
        tiles.samplesAreDifferences(are);
    }

    @Override
    synchronized void samplesAreLost(long number) {
        total = null;
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

    private synchronized Film sum() {
        long changes = tiles.changes() + splats.changes();
        if (total != null && totalOf == changes) {
            return total;
        }
        boolean isLast = isComplete();
        Film sum = tiles.film().plus(splats.film());
        total = isLast ? sum : null;
        totalOf = changes;
        return sum;
    }

    @Override
    public Image completed(Image image) {
        float[] rgb = image.toArray();
        SplatFilm film = splats.film();
        int i = 0;
        for (int y = region.y(); y < region.y() + region.height(); y++) {
            for (int x = region.x(); x < region.x() + region.width(); x++) {
                for (int c = 0; c < 3; c++, i++) {
                    rgb[i] += FloatLight.of(film.component(x, y, c), outline.display());
                }
            }
        }
        return new Image(image.width(), image.height(), rgb, outline.display());
    }
}
