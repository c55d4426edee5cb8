package enlightenment.world.contact;

import enlightenment.world.parts.Ascending;
import java.util.Arrays;
import java.util.function.Consumer;
import java.util.function.IntToDoubleFunction;

/**
 * Partitions many objects into groups, so that any two that are close in each of several numbers are in one group. A sweep along one number
 * would take quadratic time where many objects have that one in common, as all spheres of a wall have.
 */
final class CloseGroups {
    private final IntToDoubleFunction margin;
    private final Consumer<int[]> each;
    private final IntToDoubleFunction[] numbers;
    private final Runnable poll;

    /**
     * @param margin two numbers are close if they differ by at most the sum of the two objects' margins
     * @param poll called for each object and number after the first, which few need; what it throws ends this
     * @param each receives each group of at least two objects, in ascending order
     * @param numbers the numbers of each object
     */
    CloseGroups(IntToDoubleFunction margin, Runnable poll, Consumer<int[]> each, IntToDoubleFunction... numbers) {
        this.margin = margin;
        this.poll = poll;
        this.each = each;
        this.numbers = numbers;
    }

    /** Partitions these objects, given in ascending order. */
    void part(int[] items) {
        part(items, 0);
    }

    /** By each number, a chain of overlapping intervals is one group. */
    private void part(int[] items, int level) {
        if (items.length < 2) {
            return;
        }
        if (level == numbers.length) {
            each.accept(items);
            return;
        }
        double[] low = new double[items.length];
        double[] high = new double[items.length];
        for (int i = 0; i < items.length; i++) {
            if (level > 0) {
                poll.run();
            }
            double number = numbers[level].applyAsDouble(items[i]);
            double by = margin.applyAsDouble(items[i]);
            low[i] = number - by;
            high[i] = number + by;
        }
        int[] order = Ascending.order(low);
        int start = 0;
        double end = high[order[0]];
        for (int i = 1; i < order.length; i++) {
            if (low[order[i]] > end) {
                part(items, order, start, i, level + 1);
                start = i;
            }
            end = Math.max(end, high[order[i]]);
        }
        part(items, order, start, order.length, level + 1);
    }

    private void part(int[] items, int[] order, int from, int to, int level) {
        if (to - from < 2) {
            return;
        }
        int[] members = new int[to - from];
        for (int i = from; i < to; i++) {
            members[i - from] = items[order[i]];
        }
        Arrays.sort(members);
        part(members, level);
    }
}
