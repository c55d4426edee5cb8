package enlightenment.plan;

import enlightenment.method.SpreadPlaces;
import enlightenment.sampling.Hash;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.RenderSettings;
import enlightenment.work.Workers;
import enlightenment.world.CompiledScene;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;
import java.util.function.IntConsumer;

/**
 * What methods make of blocks of the picture in its full size, whose pixels learn from their neighbours, which those of a small picture have
 * not: {@code cluster} and {@code bidirectional-cluster}, beside {@code raytrace}.
 */
final class PilotBlocks {
    /** In fewer blocks little would be seen of the picture. */
    private static final int FEWEST_BLOCKS = 6;

    /** With so small an effort every pixel has as many paths as any: half of those that are planned. */
    static final double NO_EFFORT = 0x1p-40;

    private final CompiledScene scene;
    private final RenderSettings settings;
    private final int samples;

    /** Of the blocks, in pixels. */
    private final int side;

    private final List<RenderSettings.Crop> blocks = new ArrayList<>();
    private final List<PilotCell> cells;

    /** By method, its pictures of the blocks. */
    private final Map<BuiltInMethod, List<PilotPicture>> pictures = new EnumMap<>(BuiltInMethod.class);

    /** Of the light of all. */
    private double[] scale = {};

    /**
     * @param settings of the render, of all of the picture
     * @param samples per pixel
     * @param pixels how many there should be at least, about
     */
    PilotBlocks(CompiledScene scene, RenderSettings settings, int samples, double pixels) {
        this.scene = scene;
        this.settings = settings;
        this.samples = samples;
        side = Integrators.traits(BuiltInMethod.CLUSTER, settings).blockSide();
        int across = (settings.width() + side - 1) / side;
        int down = (settings.height() + side - 1) / side;
        int count = (int) Math.max(Math.ceil(pixels / pixelsOfBlock()), FEWEST_BLOCKS);
        for (int[] place : SpreadPlaces.of(across, down, Math.min(count, across * down))) {
            blocks.add(new RenderSettings.Crop(place[0] * side, place[1] * side, side, side)
                    .intersection(settings.region()));
        }
        cells = PilotCell.of(blocks);
    }

    /** The number of pixels in a block that the picture does not cut. */
    double pixelsOfBlock() {
        return (double) side * side;
    }

    /**
     * Renders the blocks.
     *
     * @param methods with blocks of the same side
     * @param purpose keeps the random numbers apart
     * @param count of pictures by each method
     */
    void render(List<BuiltInMethod> methods, long purpose, int count, BooleanSupplier cancelled) {
        PilotPicture[] made = new PilotPicture[count * methods.size()];
        Workers.run(settings.threads(), made.length, cancelled, () -> (IntConsumer) i -> {
            RenderPlan plan = plan(methods.get(i / count));
            RenderSettings mine =
                    settings.withMethod(plan.method()).withSeed(Hash.of(settings.seed(), purpose, count + i % count));
            made[i] = PilotPicture.parts(plan, scene, mine, blocks, cancelled);
        });
        if (cancelled.getAsBoolean()) {
            throw new CancellationException("stopped before a method was chosen");
        }
        for (int m = 0; m < methods.size(); m++) {
            pictures.put(methods.get(m), Arrays.asList(made).subList(m * count, (m + 1) * count));
        }
        scale = PilotScale.of(pictures.values(), cells);
    }

    private RenderPlan plan(BuiltInMethod method) {
        return method == BuiltInMethod.RAYTRACE
                ? new RenderPlan(method, samples, samples, "pilot")
                : new RenderPlan(method, NO_EFFORT, 2 * samples, "pilot");
    }

    /**
     * The relative variance of one camera sample of a method that has rendered the blocks, of which all pixels have as many; after allocation,
     * if the method allocates.
     */
    double variance(BuiltInMethod method) {
        double[] variance = PilotSpread.variance(pictures.get(method), PilotPicture::tiles);
        if (method == BuiltInMethod.RAYTRACE) {
            return PilotSpread.relative(variance, scale) * samples;
        }
        return PilotAllocation.mean(PilotSpread.ofPixels(variance, scale), cells) * samples;
    }

    /** The nanoseconds of one camera sample of a method that has rendered the blocks. */
    double cost(BuiltInMethod method) {
        List<PilotPicture> mine = pictures.get(method);
        double pixels = blocks.stream()
                .mapToDouble(block -> (double) block.width() * block.height())
                .sum();
        return mine.stream().mapToDouble(p -> PilotCosts.of(method, p.counts())).sum()
                / (pixels * samples * mine.size());
    }
}
