package enlightenment.plan;

import enlightenment.method.SpreadPlaces;
import enlightenment.sampling.Hash;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.RenderSettings;
import enlightenment.work.Workers;
import enlightenment.world.CompiledScene;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.BooleanSupplier;
import java.util.function.IntConsumer;

/**
 * What {@code cluster} makes of {@code raytrace}'s paths, seen in some blocks of the picture in its full size: its pixels learn from their
 * neighbours, which those of a small picture have not.
 */
final class PilotBlocks {
    private static final int SIDE =
            Integrators.traits(BuiltInMethod.CLUSTER, true).blockSide();

    /** With so small an effort every pixel has as many paths as any: half of those that are planned. */
    private static final double NO_EFFORT = 0x1p-40;

    private final CompiledScene scene;
    private final RenderSettings settings;
    private final int samples;
    private final List<RenderSettings.Crop> blocks = new ArrayList<>();

    /**
     * @param settings of the render, of all of the picture
     * @param samples per pixel
     * @param pixels how many there should be, about
     */
    PilotBlocks(CompiledScene scene, RenderSettings settings, int samples, double pixels) {
        this.scene = scene;
        this.settings = settings;
        this.samples = samples;
        int across = (settings.width() + SIDE - 1) / SIDE;
        int down = (settings.height() + SIDE - 1) / SIDE;
        int count = (int) Math.ceil(pixels / (SIDE * SIDE));
        for (int[] place : SpreadPlaces.of(across, down, Math.min(count, across * down))) {
            blocks.add(new RenderSettings.Crop(place[0] * SIDE, place[1] * SIDE, SIDE, SIDE)
                    .intersection(settings.region()));
        }
    }

    /** The factors between the variances and the costs of two methods' camera samples. */
    record Factors(double variance, double cost) {}

    /**
     * How much of {@code raytrace}'s variance {@code cluster} leaves, and how much more its samples cost.
     *
     * @param purpose keeps the random numbers apart
     * @param pictures of each method
     */
    Factors factors(long purpose, int pictures, BooleanSupplier cancelled) {
        List<RenderPlan> plans = List.of(
                new RenderPlan(BuiltInMethod.RAYTRACE, samples, samples, "pilot"),
                new RenderPlan(BuiltInMethod.CLUSTER, NO_EFFORT, 2 * samples, "pilot"));
        PilotPicture[] made = new PilotPicture[2 * pictures];
        Workers.run(settings.threads(), made.length, cancelled, () -> (IntConsumer) i -> {
            RenderPlan plan = plans.get(i / pictures);
            RenderSettings mine = settings.withMethod(plan.method())
                    .withSeed(Hash.of(settings.seed(), purpose, pictures + i % pictures));
            made[i] = PilotPicture.parts(plan, scene, mine, blocks, cancelled);
        });
        if (cancelled.getAsBoolean()) {
            return new Factors(1, 1);
        }
        List<PilotPicture> all = Arrays.asList(made);
        double[] scale = PilotSpread.scale(PilotSpread.mean(all));
        double ray = variance(all.subList(0, pictures), scale);
        double cluster = variance(all.subList(pictures, made.length), scale);
        return new Factors(
                ray > 0 ? cluster / ray : 1,
                cost(BuiltInMethod.CLUSTER, all.subList(pictures, made.length))
                        / cost(BuiltInMethod.RAYTRACE, all.subList(0, pictures)));
    }

    private static double variance(List<PilotPicture> of, double[] scale) {
        return PilotSpread.relative(PilotSpread.variance(of, PilotPicture::tiles), scale);
    }

    private static double cost(BuiltInMethod method, List<PilotPicture> of) {
        return of.stream().mapToDouble(p -> PilotCosts.of(method, p.counts())).sum();
    }
}
