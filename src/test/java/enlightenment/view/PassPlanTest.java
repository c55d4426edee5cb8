package enlightenment.view;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.image.Image;
import enlightenment.view.frame.PassPlan;
import enlightenment.view.frame.PictureSum;
import java.util.HashSet;
import java.util.Set;
import org.junit.jupiter.api.Test;

class PassPlanTest {
    private static final long MEGAPIXEL = 1_000_000;

    @Test
    void theFirstPassIsTheFinestThatIsThereAtOnce() {
        assertEquals(32, PassPlan.first(Double.POSITIVE_INFINITY, MEGAPIXEL).shrink());
        assertEquals(16, PassPlan.first(1, MEGAPIXEL).shrink());
        // 0.4 s for all pixels: 0.1 s at half, 0.025 s at a quarter of the resolution.
        assertEquals(4, PassPlan.first(4e-7, MEGAPIXEL).shrink());
        assertEquals(1, PassPlan.first(1e-8, MEGAPIXEL).shrink());
    }

    @Test
    void smallPicturesAreNotMadeSmallerThanNeeded() {
        // 384 pixels take no time; 900 do neither at 30 by 30, of 60 by 60 that do.
        assertEquals(1, PassPlan.first(Double.POSITIVE_INFINITY, 24 * 16).shrink());
        assertEquals(2, PassPlan.first(Double.POSITIVE_INFINITY, 60 * 60).shrink());
    }

    @Test
    void resolutionDoublesUntilItIsFullThenSamplesAreAdded() {
        PassPlan pass = PassPlan.first(1, MEGAPIXEL);
        for (int shrink = 16; shrink > 1; shrink /= 2) {
            assertEquals(new PassPlan(shrink, 0, 1, 0), pass);
            pass = pass.next(1, 16);
        }
        assertEquals(new PassPlan(1, 0, 1, 0), pass);
        assertEquals(new PassPlan(1, 1, 1, 1), pass.next(1, 16));
    }

    @Test
    void passesAddUpToAllSamplesWithNumbersOfTheirOwn() {
        for (double seconds : new double[] {0, 0.2, 1, 100}) {
            Set<Integer> numbers = new HashSet<>();
            int sum = 0;
            for (PassPlan pass = PassPlan.first(0, 1); pass != null; pass = pass.next(seconds, 1000)) {
                assertEquals(sum, pass.before());
                assertTrue(numbers.add(pass.number()));
                sum += pass.samples();
            }
            assertEquals(1000, sum);
        }
        assertNull(new PassPlan(1, 0, 1, 0).next(1, 1));
    }

    @Test
    void shortPassesGrowAndLongOnesShrink() {
        PassPlan pass = new PassPlan(1, 5, 8, 40);
        assertEquals(16, pass.next(0.1, 1000).samples());
        assertEquals(8, pass.next(0.7, 1000).samples());
        assertEquals(4, pass.next(5, 1000).samples());
    }

    @Test
    void theMeanWeighsPicturesByTheirSamples() {
        PictureSum sum = new PictureSum();
        sum.add(new Image(1, 1, new float[] {1, 0, 4}), 1);
        Image mean = sum.add(new Image(1, 1, new float[] {5, 8, 4}), 3);
        assertEquals(4, mean.component(0, 0, 0));
        assertEquals(6, mean.component(0, 0, 1));
        assertEquals(4, mean.component(0, 0, 2));
    }

    @Test
    void aViewFitsIntoItsBoxWithinTheLimits() {
        assertEquals(new ViewSize(400, 200), ViewSize.fitting(800, 400, 400, 1000));
        assertEquals(new ViewSize(1000, 500), ViewSize.fitting(800, 400, 5000, 500));
        assertEquals(new ViewSize(1, 1), ViewSize.fitting(65_536, 1, 1, 1));
        ViewSize largest = ViewSize.fitting(1, 1, 65_536, 65_536);
        assertEquals(new ViewSize(2048, 2048), largest);
        assertTrue(ViewSize.fitting(65_536, 1, 65_536, 65_536).width() <= ViewSize.MOST_SIDE);
    }
}
