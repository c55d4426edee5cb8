package enlightenment.sampling;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.HashSet;
import java.util.Set;
import org.junit.jupiter.api.Test;

class SobolTest {
    private static final int LOG = 6;
    private static final int COUNT = 1 << LOG;

    @Test
    void everyAlignedRunOfPointsHasOnePointInEachBoxOfEveryDyadicShape() {
        for (long seed = 0; seed < 50; seed++) {
            long s = Hash.mix(seed);
            for (int start = 0; start < 4 * COUNT; start += COUNT) {
                for (int a = 0; a <= LOG; a++) {
                    int columns = 1 << a;
                    int rows = 1 << (LOG - a);
                    Set<Integer> boxes = new HashSet<>();
                    for (int i = start; i < start + COUNT; i++) {
                        boxes.add((int) (Sobol.x(i, s) * columns) * rows + (int) (Sobol.y(i, s) * rows));
                    }
                    assertEquals(
                            COUNT, boxes.size(), "seed " + seed + ", start " + start + ", " + columns + " columns");
                }
            }
        }
    }

    @Test
    void aSinglePointIsUniformlyDistributedOverSeeds() {
        int cells = 8;
        int[] counts = new int[cells * cells];
        int seeds = 64_000;
        for (int k = 0; k < seeds; k++) {
            long s = Hash.mix(k);
            counts[(int) (Sobol.x(5, s) * cells) * cells + (int) (Sobol.y(5, s) * cells)]++;
        }
        double expected = (double) seeds / counts.length;
        double chi2 = 0;
        for (int c : counts) {
            chi2 += (c - expected) * (c - expected) / expected;
        }
        // 63 degrees of freedom: mean 63, standard deviation sqrt(126) = 11.2; six of them are never exceeded by
        // chance.
        assertTrue(chi2 < 63 + 6 * 11.2, "chi² " + chi2);
    }

    @Test
    void shuffledIndicesArePermutedWithinAlignedBlocks() {
        for (long seed = 0; seed < 20; seed++) {
            long s = Hash.mix(seed);
            for (int log = 0; log <= 8; log++) {
                int n = 1 << log;
                Set<Integer> low = new HashSet<>();
                Set<Integer> block = new HashSet<>();
                for (int i = 0; i < n; i++) {
                    int k = Sobol.shuffled(i, s);
                    low.add(k & (n - 1));
                    block.add(k >>> log);
                }
                assertEquals(n, low.size());
                assertEquals(1, block.size());
            }
        }
    }

    @Test
    void sequencesReadAtShuffledIndicesAreIndependentOfTheUnshuffledOne() {
        // The sum of products of centred coordinates within a pixel, squared, averaged over many pixels.
        int n = 0;
        double sum = 0;
        for (int pixel = 0; pixel < 2000; pixel++) {
            long a = Hash.of(pixel, 1);
            long b = Hash.of(pixel, 2);
            double inner = 0;
            for (int i = 0; i < 16; i++) {
                inner += (Sobol.x(i, a) - 0.5) * (Sobol.x(Sobol.shuffled(i, Hash.mix(b)), b) - 0.5);
            }
            sum += inner * inner;
            n++;
        }
        // The leading digits agree for 8 pairs of indices or for none, at random: (16/16)²/8 = 0.125; all further
        // digits
        // together add less than as much again. Read at the same indices, the sum would be (16/12)² or so every time.
        assertTrue(sum / n < 0.25, "mean square " + sum / n);
    }
}
