package enlightenment.method;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.world.CompiledScene;
import java.util.Arrays;
import java.util.HashSet;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class ExposureTest {
    private static Exposure of(int count) {
        return new Exposure(new CompiledScene[count], scene -> null);
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 7, 16, 100, 256})
    void eachBlockOfSamplesSeesEveryMomentOnce(int count) {
        Exposure exposure = of(count);
        for (int pixel = 0; pixel < 20; pixel++) {
            exposure.pixel(5, pixel, 3);
            for (int block = 0; block < 5; block++) {
                Set<Integer> seen = new HashSet<>();
                for (int i = 0; i < count; i++) {
                    seen.add(exposure.moment(block * count + i));
                }
                assertEquals(count, seen.size());
            }
        }
    }

    /** The largest gap that four samples leave among sixteen moments: four would be even, consecutive ones leave thirteen. */
    @Test
    void aPartOfABlockIsSpreadOverTheTime() {
        Exposure exposure = of(16);
        for (int pixel = 0; pixel < 20; pixel++) {
            exposure.pixel(1, pixel, 0);
            int[] seen = new int[4];
            Arrays.setAll(seen, exposure::moment);
            Arrays.sort(seen);
            int largest = seen[0] + 16 - seen[3];
            for (int i = 1; i < seen.length; i++) {
                largest = Math.max(largest, seen[i] - seen[i - 1]);
            }
            assertTrue(largest <= 7, Arrays.toString(seen));
        }
    }

    /** 20,000 pixels of 7 moments: the standard deviation of a count is 49.5; five of these are exceeded in one test of 250,000. */
    @Test
    void theFirstSampleOfAPixelSeesEveryMomentEquallyOften() {
        Exposure exposure = of(7);
        int[] counts = new int[7];
        for (int y = 0; y < 100; y++) {
            for (int x = 0; x < 200; x++) {
                exposure.pixel(11, x, y);
                counts[exposure.moment(0)]++;
            }
        }
        for (int count : counts) {
            assertEquals(20_000 / 7.0, count, 5 * 49.5);
        }
    }
}
