package enlightenment.engine;

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
import java.util.ArrayList;
import java.util.List;
import java.util.function.BooleanSupplier;

/**
 * The whole picture from early on: a first pass that costs the same whatever is asked for, finer ones with a small share of the
 * samples, over which the finished tiles are put. Nothing of it goes into a picture that becomes complete. For use by several threads at
 * once.
 */
public final class Preview {
    /** The longest side of the squares that show one sample. */
    private static final int COARSEST = 8;

    /** Samples per pixel of the first pass, with one light point each: as many as the squares take. */
    private static final double FIRST = 1.0 / (COARSEST * COARSEST);

    private final CompiledScene scene;
    private final RenderSettings settings;
    private final RenderSettings.Crop region;
    private final TileGrid grid;
    private final Kind kind;
    private final float[] rgb;
    private final boolean[] shown;
    private long shownPixels;

    /** Which passes there are. */
    public enum Kind {
        /** Up to an eighth of the samples. A render that is stopped keeps what they show. */
        FINE {
            /** The last pass takes this share of the samples. */
            private static final double LAST_SHARE = 1.0 / 8;

            /** With this many samples per pixel, the step from one to the last pass is so long that one per pixel comes between. */
            private static final double MANY = 64;

            @Override
            List<Double> passes(double samples) {
                double last = LAST_SHARE * samples;
                return samples < MANY ? List.of(Math.min(last, 1)) : List.of(1.0, last);
            }

            @Override
            double share() {
                // At most: where there are many samples.
                return LAST_SHARE + (1 + FIRST) / MANY;
            }
        },

        /**
         * For those who look at a render: up to one sample per pixel, as far as a fiftieth of the samples suffices. No result of it keeps what
         * they show, so they must not take long.
         */
        COARSE {
            private static final double SHARE = 1.0 / 50;

            /** Each pass has this many times the samples of the one before: squares of half the side, while there are squares. */
            private static final double STEP = 4;

            @Override
            List<Double> passes(double samples) {
                List<Double> passes = new ArrayList<>();
                double sum = FIRST;
                for (double next = STEP * FIRST; next <= 1 && sum + next <= SHARE * samples; next *= STEP) {
                    passes.add(next);
                    sum += next;
                }
                return passes;
            }

            @Override
            double share() {
                return SHARE;
            }
        };

        /** Samples per pixel of the passes that follow the first, in a render of this many samples per pixel. */
        abstract List<Double> passes(double samples);

        abstract double share();
    }

    /** A preview of which nothing is rendered yet; takes the memory of an image. */
    public Preview(Kind kind, CompiledScene scene, RenderSettings settings) {
        this.kind = kind;
        this.scene = scene;
        this.settings = settings;
        grid = new TileGrid(settings, Integrators.traits(settings).blockSide());
        region = settings.region();
        rgb = new float[3 * region.width() * region.height()];
        shown = new boolean[region.width() * region.height()];
    }

    /** Whether a render that is stopped keeps what the passes show. */
    public boolean isKept() {
        return kind == Kind.FINE;
    }

    /** The largest share of the samples that all passes take together, where there is at least one sample per pixel. */
    public double share() {
        return kind.share();
    }

    /** Renders the first pass, with which the picture becomes whole. */
    public void begin(BooleanSupplier cancelled) {
        pass(FIRST, null, () -> {}, cancelled);
    }

    /**
     * Renders the passes that follow the first.
     *
     * @param planner of the render
     * @param plan of the render
     * @param told is run after each tile of a pass, by one thread at a time
     */
    public void refine(Planner planner, RenderPlan plan, Runnable told, BooleanSupplier cancelled) {
        for (double samples : kind.passes(plan.samples())) {
            RenderPlan few = kind == Kind.FINE ? planner.preview(samples).orElse(null) : null;
            pass(samples, few, told, cancelled);
        }
    }

    /** @param few the method's plan for this number of samples; null for the cheapest picture that resembles it */
    private void pass(double samples, RenderPlan few, Runnable told, BooleanSupplier cancelled) {
        boolean own = few != null;
        // Too few for the method: the cheapest that resembles it, if need be not in all pixels.
        RenderSettings how = own ? settings : Integrators.cheapest(settings);
        RenderPlan plan = own ? few : new RenderPlan(how.method(), Math.max(samples, 1), samples, "preview");
        int side = own || samples >= 1 ? 0 : Math.min((int) Math.ceil(Math.sqrt(1 / samples)), COARSEST);
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
                    told.run();
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
    public synchronized void put(FilmTile tile) {
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

    /** The number of pixels that have samples. */
    public synchronized long shownPixels() {
        return shownPixels;
    }

    /** The picture of the samples so far. */
    public synchronized Image image() {
        return new Image(region.width(), region.height(), rgb.clone(), scene.display);
    }

    /**
     * Finished pixels, and where there are none what this shows, with what paths have brought so far.
     *
     * @param film a picture in the making, of the same settings
     * @param finished its image
     */
    public Image beneath(PictureFilm film, Image finished) {
        Image coarse = film.completed(image());
        float[] mixed = coarse.toArray();
        float[] fine = finished.toArray();
        for (int i = 0; i < region.width() * region.height(); i++) {
            if (film.samples(region.x() + i % region.width(), region.y() + i / region.width()) > 0) {
                System.arraycopy(fine, 3 * i, mixed, 3 * i, 3);
            }
        }
        return new Image(region.width(), region.height(), mixed, coarse.curve());
    }
}
