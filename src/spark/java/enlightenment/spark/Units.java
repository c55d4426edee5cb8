package enlightenment.spark;

import java.util.ArrayList;
import java.util.List;

/** Cuts what is to be done into units, one per task. */
final class Units {
    /** A task costs its driver milliseconds and its executor tens of them; a lost executor loses half of this per core. */
    static final double SECONDS = 4;

    /** Larger results would wait for each other in the driver's memory. */
    private static final long MOST_BYTES = 8 << 20;

    private Units() {}

    /** Every n-th tile to a unit, so that units take about equally long; none is empty. */
    static List<int[]> deal(int[] tiles, int units) {
        int n = Math.max(Math.min(units, tiles.length), 1);
        List<int[]> all = new ArrayList<>();
        for (int u = 0; u < n; u++) {
            int[] unit = new int[(tiles.length - u + n - 1) / n];
            for (int i = 0; i < unit.length; i++) {
                unit[i] = tiles[u + i * n];
            }
            all.add(unit);
        }
        return all;
    }

    /**
     * How many units to cut: whole waves of one per core, of at most {@link #SECONDS} each.
     *
     * @param seconds how long all takes on one core
     * @param cores how many cores there are
     * @param bytes how large all results are
     */
    static int number(double seconds, int cores, long bytes) {
        double waves = Math.max(Math.ceil(seconds / SECONDS / cores), 1);
        return (int) Math.min(Math.max(waves * cores, (double) (bytes / MOST_BYTES + 1)), Integer.MAX_VALUE);
    }
}
