package enlightenment.method.metropolis;

import enlightenment.classic.shading.ClassicShader;
import enlightenment.film.FilmTile;
import enlightenment.film.TilePasses;
import enlightenment.method.Block;
import enlightenment.method.RayTraceMethod;
import enlightenment.method.TileIntegrator;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.RenderSettings;
import enlightenment.transport.path.PathIntegrator;
import enlightenment.transport.state.PathPart;
import enlightenment.world.CompiledScene;
import enlightenment.world.parts.RayCounters;
import java.util.List;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;

/**
 * Metropolis light transport by Markov chains within blocks of the picture: the paper's ray clusters, whose rays propose new ones near
 * them, made unbiased (docs/notes/metropolis.md). For physical shading chains estimate light that was scattered at least twice; direct
 * light is estimated by evenly spaced rays.
 *
 * <p>A tile should consist of whole blocks; a block that two tiles share is rendered twice.
 */
public final class MetropolisMethod implements TileIntegrator {
    /** A tile's quarters are alike; each may be a pass. */
    private static final int QUARTERS = 4;

    private static final int PERCENT = 100;

    private final RenderSettings settings;
    private final Paths paths;
    private final BlockChains chains;
    private final Spending spending;

    /** Estimates direct light; null where chains estimate all light. */
    private final RayTraceMethod direct;

    /** The number of samples that each pixel reports as its own in a quarter; all other paths are reported as those of a survey. */
    private final int counted;

    private final double[] sums = new double[6];

    /** Receives the statistics of chains; null if they are not wanted. */
    private final Consumer<List<ChainStatistics>> sink;

    /**
     * For one thread.
     *
     * @param samples per pixel in the mean, all paths together
     * @param sink receives the chains of each quarter of a block; null if they are not wanted
     */
    public MetropolisMethod(
            CompiledScene scene,
            RenderSettings settings,
            RayCounters counters,
            double samples,
            Consumer<List<ChainStatistics>> sink) {
        this.settings = settings;
        this.sink = sink;
        boolean isPhysical = scene.physical != null;
        spending = Spending.of(samples, isPhysical);
        BuiltInMethod.MetropolisSettings own = BuiltInMethod.MetropolisSettings.of(settings);
        paths = new Paths(scene, settings, moment -> {
            RayCounters counted = scene.countersOf(moment, counters);
            return isPhysical
                    ? new PathIntegrator(moment, counted, PathPart.INDIRECT)
                    : ClassicShader.ofColors(moment, 1, counted);
        });
        direct = isPhysical ? RayTraceMethod.ofDirectLight(scene, settings, counters, spending.direct()) : null;
        chains = new BlockChains(paths, (double) own.largeSteps() / PERCENT, own.mutations(), counters, sink != null);
        // At most the number taken where all is dark; a power of two, at which error estimates are best.
        counted = Math.max(Integer.highestOneBit((int) samples) / (2 * QUARTERS), 1);
    }

    @Override
    public void stopWhen(BooleanSupplier cancelled) {
        paths.stopWhen(cancelled);
        if (direct != null) {
            direct.stopWhen(cancelled);
        }
    }

    @Override
    public boolean dividesIntoPasses() {
        return true;
    }

    @Override
    public void render(FilmTile tile, int pass, int passes) {
        TilePasses.check(pass, passes, QUARTERS);
        if (passes == 1) {
            renderAll(tile, QUARTERS);
        } else {
            renderQuarter(tile, pass);
        }
    }

    private void renderQuarter(FilmTile tile, int quarter) {
        FilmTile seen = tile.like(tile.x, tile.y, tile.width, tile.height);
        if (direct != null) {
            direct.render(seen, quarter, QUARTERS);
            tile.addLostSamples(seen.lostSamples());
        }
        Block.forEach(tile, settings.width(), settings.height(), BuiltInMethod.MetropolisSettings.BLOCK_SIDE, block -> {
            chains.render(block, quarter, spending, settings.seed());
            tile.addSurveyRays(Math.max(chains.taken() + put(block, seen, tile), 0));
            tile.addLostSamples(chains.lost());
            if (sink != null) {
                sink.accept(chains.statistics());
            }
        });
    }

    /** Writes the pixels of a block; returns the number of direct samples beyond those that the pixels report. */
    private long put(Block block, FilmTile seen, FilmTile tile) {
        long rays = 0;
        for (int row = Math.max(block.y(), tile.y);
                row < Math.min(block.y() + block.height(), tile.y + tile.height);
                row++) {
            for (int column = Math.max(block.x(), tile.x);
                    column < Math.min(block.x() + block.width(), tile.x + tile.width);
                    column++) {
                int pixel = (row - block.y()) * block.width() + column - block.x();
                for (int c = 0; c < 3; c++) {
                    sums[2 * c] = counted * (seen.mean(column, row, c) + chains.light(pixel, c));
                }
                tile.put(column, row, sums, 0, counted);
                rays += seen.count(column, row) - counted;
            }
        }
        return rays;
    }
}
