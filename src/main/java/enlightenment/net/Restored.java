package enlightenment.net;

import java.util.List;
import java.util.Set;

/**
 * What an earlier incarnation of the server had.
 *
 * @param tiles the tiles that are done
 * @param expelled keys of workers that are not to be trusted
 */
record Restored(List<Tile> tiles, Set<String> expelled) {
    static final Restored NOTHING = new Restored(List.of(), Set.of());

    /** A tile: who made it, what it is, and whether another worker made the same. */
    record Tile(int tile, String key, ContentHash hash, boolean confirmed) {}
}
