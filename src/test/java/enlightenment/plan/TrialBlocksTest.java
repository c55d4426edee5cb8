package enlightenment.plan;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.color.DisplayCurve;
import enlightenment.film.FilmTile;
import enlightenment.render.TestScenes;
import enlightenment.scene.RenderSettings;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class TrialBlocksTest {
    private static final RenderSettings SETTINGS =
            RenderSettings.of(TestScenes.whiteFireAndIce().build()).withSize(800, 400);

    private static Set<Integer> places(List<FilmTile> blocks) {
        Set<Integer> places = new HashSet<>();
        for (FilmTile block : blocks) {
            assertTrue(places.add(block.y / 8 * 100 + block.x / 8), "a block is there twice");
        }
        return places;
    }

    @Test
    void phasesHaveNoBlockInCommonAndTogetherAreAll() {
        TrialBlocks blocks = new TrialBlocks(SETTINGS.withSeed(7), DisplayCurve.NONE, FilmTile.BLOCK_SIDE);
        Set<Integer> all = new HashSet<>();
        int sum = 0;
        for (int phase = 0; phase < 16; phase++) {
            Set<Integer> places = places(blocks.phase(phase, 1.0 / 16));
            sum += places.size();
            all.addAll(places);
            assertEquals(5000 / 16.0, places.size(), 8);
        }
        assertEquals(5000, all.size());
        assertEquals(5000, sum);
    }

    @Test
    void noBlockIsAskedTwiceWhetherItShowsSomething() {
        TrialBlocks blocks = new TrialBlocks(SETTINGS.withSeed(7), DisplayCurve.NONE, FilmTile.BLOCK_SIDE);
        Set<RenderSettings.Crop> asked = new HashSet<>();
        TrialBlocks.Seen seen = blocks.seen(1.0 / 16, area -> {
            assertTrue(asked.add(area), "twice: " + area);
            return area.x() < 400;
        });
        assertEquals(5000, asked.size());
        assertEquals(0.5, seen.share());
        // A sixteenth of all, from the half that shows something.
        assertEquals(5000 / 16.0, places(seen.blocks()).size(), 8);
        assertTrue(seen.blocks().stream().allMatch(block -> block.x < 400));
    }

    /** Wherever a thing of 3 × 3 blocks is, a sixteenth of the blocks meet it with about half of the seeds. */
    @Test
    void aSmallThingIsMetWithAboutAsManySeedsWhereverItIs() {
        int seeds = 200;
        for (int[] place : new int[][] {{10, 10}, {50, 20}, {83, 41}, {0, 0}, {97, 47}}) {
            int met = 0;
            for (int seed = 0; seed < seeds; seed++) {
                List<FilmTile> blocks = new TrialBlocks(SETTINGS.withSeed(seed), DisplayCurve.NONE, FilmTile.BLOCK_SIDE)
                        .phase(0, 1.0 / 16);
                met += blocks.stream()
                                .anyMatch(b ->
                                        Math.abs(b.x / 8 - place[0] - 1) <= 1 && Math.abs(b.y / 8 - place[1] - 1) <= 1)
                        ? 1
                        : 0;
            }
            // Nine different thresholds of 1/16 each; evenly spread, so few of them meet it twice.
            assertEquals(9.0 / 16, met / (double) seeds, 0.15);
        }
    }

    @ParameterizedTest
    @ValueSource(longs = {0, 1, -1, Long.MIN_VALUE, Long.MAX_VALUE})
    void ofACropThereAreOnlyItsOwnPixels(long seed) {
        RenderSettings settings = SETTINGS.withSeed(seed).withCrop(new RenderSettings.Crop(13, 21, 100, 3));
        TrialBlocks blocks = new TrialBlocks(settings, DisplayCurve.NONE, FilmTile.BLOCK_SIDE);
        // Columns 1 to 14 of row 2.
        assertEquals(14, blocks.count());
        int pixels = 0;
        for (int phase = 0; phase < 2; phase++) {
            for (FilmTile b : blocks.phase(phase, 0.5)) {
                assertTrue(b.x >= 13 && b.y >= 21 && b.x + b.width <= 113 && b.y + b.height <= 24);
                pixels += b.width * b.height;
            }
        }
        assertEquals(300, pixels);
    }

    @Test
    void thereIsAlwaysOne() {
        RenderSettings settings = SETTINGS.withCrop(new RenderSettings.Crop(0, 0, 1, 1));
        for (long seed = 0; seed < 20; seed++) {
            assertEquals(
                    1,
                    new TrialBlocks(settings.withSeed(seed), DisplayCurve.NONE, FilmTile.BLOCK_SIDE)
                            .phase(0, 0.01)
                            .size());
        }
    }
}
