package enlightenment.world.parts;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;

import java.util.Comparator;
import java.util.Random;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

class AscendingTest {
    private static final double[] SPECIAL = {
        0.0,
        -0.0,
        1,
        -1,
        Double.NaN,
        Double.POSITIVE_INFINITY,
        Double.NEGATIVE_INFINITY,
        Double.MIN_VALUE,
        -Double.MIN_VALUE
    };

    private static int[] byComparison(double[] numbers) {
        return IntStream.range(0, numbers.length)
                .boxed()
                .sorted(Comparator.comparingDouble(i -> numbers[i]))
                .mapToInt(i -> i)
                .toArray();
    }

    @Test
    void theOrderIsThatOfAStableSort() {
        Random random = new Random(3);
        for (int n : new int[] {0, 1, 2, 3, 10, 1000, 20_000}) {
            double[] different = random.doubles(n, -1e3, 1e3).toArray();
            double[] few = random.ints(n, -3, 4).mapToDouble(i -> i).toArray();
            double[] special = random.ints(n, 0, SPECIAL.length)
                    .mapToDouble(i -> SPECIAL[i])
                    .toArray();
            for (double[] numbers : new double[][] {different, few, special}) {
                assertArrayEquals(byComparison(numbers), Ascending.order(numbers));
            }
        }
    }
}
