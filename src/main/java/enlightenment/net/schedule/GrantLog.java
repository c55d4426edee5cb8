package enlightenment.net.schedule;

import enlightenment.checkpoint.Origin;
import java.util.Arrays;

/**
 * Which machines each tile was granted to by this incarnation of the server, whether the leases still hold or not: only their results
 * count.
 */
final class GrantLog {
    /** Machines remembered of a tile, the latest ones: otherwise machines that come and go would fill the memory. */
    private static final int MOST = 8;

    private static final Origin[] NONE = {};

    private final Origin[][] byTile;

    GrantLog(int tiles) {
        byTile = new Origin[tiles][];
        Arrays.fill(byTile, NONE);
    }

    /** The tiles {@code first} (included) to {@code last} (excluded) are granted to the machine. */
    void granted(Origin to, int first, int last) {
        for (int tile = first; tile < last; tile++) {
            if (!isGranted(to, tile)) {
                byTile[tile] = with(byTile[tile], to);
            }
        }
    }

    private static Origin[] with(Origin[] before, Origin one) {
        int from = before.length == MOST ? 1 : 0;
        Origin[] after = Arrays.copyOfRange(before, from, before.length + 1);
        after[after.length - 1] = one;
        return after;
    }

    /** Whether the tile was granted to the machine. */
    boolean isGranted(Origin to, int tile) {
        for (Origin one : byTile[tile]) {
            if (one.equals(to)) {
                return true;
            }
        }
        return false;
    }
}
