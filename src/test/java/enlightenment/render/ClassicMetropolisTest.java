package enlightenment.render;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.render.BlockMeans.Verdict;
import enlightenment.render.ManySeeds.Picture;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Markov chains over places on the film and points of lights mean the picture of evenly spaced rays in classic shading, too. */
class ClassicMetropolisTest {
    private static final int WIDTH = 72;
    private static final int HEIGHT = 16;
    private static final int SEEDS = 24;
    private static final BlockMeans BLOCKS = new BlockMeans(WIDTH, HEIGHT);

    private static RenderSettings settings(Scene scene, int mutations) {
        return RenderSettings.of(scene)
                .using(new BuiltInMethod.MetropolisSettings(10, mutations))
                .withSize(WIDTH, HEIGHT)
                .withBudget(RenderSettings.Budget.NONE.withSamples(8));
    }

    private static List<double[]> rgb(List<Picture> pictures) {
        return pictures.stream().map(Picture::rgb).toList();
    }

    @ParameterizedTest
    @CsvSource({"fire-and-ice, 1", "fire-and-ice, 1000", "glass, 1000", "keyhole, 1", "keyhole, 1000"})
    void chainsOfAnyLengthMeanThePictureOfEvenlySpacedRays(String name, int mutations) {
        Scene scene = ManySeeds.shipped(name);
        RenderSettings traced = RenderSettings.of(scene)
                .withSize(WIDTH, HEIGHT)
                .withAntialias(4)
                .with(new BuiltInMethod.RayTraceSettings(4));
        Verdict v = BLOCKS.compare(
                rgb(ManySeeds.render(scene, settings(scene, mutations), 0, SEEDS)),
                rgb(ManySeeds.render(scene, traced, 1000, SEEDS)));
        assertFalse(v.isDifferent(), name + ": " + v);
        assertTrue(v.most() < 5, name + ": " + v);
    }

    @Test
    void aPartOfThePictureHasTheBytesOfTheWhole() {
        Scene scene = ManySeeds.shipped("keyhole");
        RenderSettings settings = settings(scene, 100);
        double[] whole = ManySeeds.render(scene, settings).rgb();
        RenderSettings.Crop part = new RenderSettings.Crop(60, 5, 10, 8);
        double[] cropped =
                ManySeeds.render(scene, settings.withCrop(part).withThreads(3)).rgb();
        for (int y = 0; y < part.height(); y++) {
            int from = 3 * ((part.y() + y) * WIDTH + part.x());
            assertArrayEquals(
                    Arrays.copyOfRange(whole, from, from + 3 * part.width()),
                    Arrays.copyOfRange(cropped, 3 * part.width() * y, 3 * part.width() * (y + 1)));
        }
        for (int side : new int[] {1, 65, 1000}) {
            assertArrayEquals(
                    whole, ManySeeds.render(scene, settings.withTileSize(side)).rgb());
        }
    }
}
