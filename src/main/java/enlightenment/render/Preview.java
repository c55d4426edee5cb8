package enlightenment.render;

import enlightenment.engine.TileGrid;
import enlightenment.film.FilmTile;
import enlightenment.image.Image;
import enlightenment.method.TileIntegrator;
import enlightenment.plan.Integrators;
import enlightenment.plan.Planner;
import enlightenment.plan.RenderPlan;
import enlightenment.scene.RenderSettings;
import enlightenment.work.Workers;
import enlightenment.world.CompiledScene;
import enlightenment.world.parts.RayCounters;
import java.util.function.BooleanSupplier;

/**
 * The whole picture from early on: a first pass that costs the same whatever is asked for, finer ones with a small share of the
 * samples, over which the finished tiles are put. Nothing of it goes into the picture that is rendered.
 */
final class Preview {
    /** The longest side of the squares that show one sample. */
    private static final int COARSEST = 8;

    /** Samples per pixel of the first pass, with one light point each: as many as the squares take. */
    private static final double FIRST = 1.0 / (COARSEST * COARSEST);

    /** The last pass takes this share of the samples. */
    private static final double LAST_SHARE = 1.0 / 8;

    /** With this many samples per pixel, the step from one to the last pass is so long that one per pixel comes between. */
    private static final double MANY = 64;

    /** What the passes take together, as a share of the samples, at most: where there are {@link #MANY}. */
    static final double SHARE = LAST_SHARE + (1 + FIRST) / MANY;

    private final CompiledScene scene;
    private final RenderSettings settings;
    private final RenderSettings.Crop region;
    private final TileGrid grid;
    private final Planner planner;
    private final float[] rgb;
    private final boolean[] shown;
    private long shownPixels;

    Preview(CompiledScene scene, RenderSettings settings, Planner planner) {
        this.scene = scene;
        this.settings = settings;
        grid = new TileGrid(settings, Integrators.traits(settings.method()).blockSide());
        this.planner = planner;
        region = settings.region();
        rgb = new float[3 * region.width() * region.height()];
        shown = new boolean[region.width() * region.height()];
    }

    /** Renders the passes. Tells of the progress of all but the first, with which the picture becomes whole. */
    void run(RenderPlan plan, RenderProgress progress, BooleanSupplier cancelled) {
        pass(FIRST, null, RenderProgress.NONE, cancelled);
        double last = LAST_SHARE * plan.samples();
        for (double samples : plan.samples() < MANY ? new double[] {Math.min(last, 1)} : new double[] {1, last}) {
            pass(samples, planner.preview(samples).orElse(null), progress, cancelled);
        }
    }

    /** @param few the method's plan for this number of samples, or null if that is too few for it */
    private void pass(double samples, RenderPlan few, RenderProgress progress, BooleanSupplier cancelled) {
        boolean own = few != null;
        // Too few for the method: the cheapest that resembles it, if need be not in all pixels.
        RenderSettings how = own ? settings : Integrators.cheapest(settings);
        RenderPlan plan = own ? few : new RenderPlan(how.method(), Math.max(samples, 1), samples, "preview");
        int side = own || samples >= 1 ? 0 : Math.min((int) Math.ceil(Math.sqrt(1 / samples)), COARSEST);
        long total = (long) region.width() * region.height();
        Workers.run(settings.threads(), grid.tiles(), cancelled, () -> {
            TileIntegrator method =
                    (TileIntegrator) Integrators.of(plan, scene, how, new RayCounters(scene.kindNames.size()));
            method.stopWhen(cancelled);
            return turn -> {
                RenderSettings.Crop place = grid.place(turn);
                FilmTile tile = new FilmTile(place.x(), place.y(), place.width(), place.height(), scene.display);
                if (side == 0) {
                    method.render(tile);
                    put(tile);
                } else {
                    renderSquares(method, tile, side);
                }
                synchronized (this) {
                    progress.progress(0, total, this::image);
                }
            };
        });
    }

    /** One sample for each square of pixels; squares are cut from the whole picture's corner and at the tile's border. */
    private void renderSquares(TileIntegrator method, FilmTile tile, int side) {
        int right = tile.x + tile.width;
        int bottom = tile.y + tile.height;
        for (int y = tile.y; y < bottom; y = (y / side + 1) * side) {
            for (int x = tile.x; x < right; x = (x / side + 1) * side) {
                int width = Math.min((x / side + 1) * side, right) - x;
                int height = Math.min((y / side + 1) * side, bottom) - y;
                FilmTile middle = tile.like(x + width / 2, y + height / 2, 1, 1);
                method.render(middle);
                fill(x, y, width, height, middle);
            }
        }
    }

    private synchronized void fill(int x, int y, int width, int height, FilmTile one) {
        for (int row = y; row < y + height; row++) {
            for (int column = x; column < x + width; column++) {
                show(column, row, one, one.x, one.y);
            }
        }
    }

    /** Puts a tile over what was there. */
    synchronized void put(FilmTile tile) {
        for (int row = tile.y; row < tile.y + tile.height; row++) {
            for (int column = tile.x; column < tile.x + tile.width; column++) {
                show(column, row, tile, column, row);
            }
        }
    }

    private void show(int column, int row, FilmTile tile, int fromColumn, int fromRow) {
        int pixel = (row - region.y()) * region.width() + column - region.x();
        for (int c = 0; c < 3; c++) {
            rgb[3 * pixel + c] = (float) tile.mean(fromColumn, fromRow, c);
        }
        shownPixels += shown[pixel] ? 0 : 1;
        shown[pixel] = true;
    }

    /** How many pixels are not black for want of samples. */
    synchronized long shownPixels() {
        return shownPixels;
    }

    /** What there is. */
    synchronized Image image() {
        return new Image(region.width(), region.height(), rgb.clone(), scene.display);
    }
}
