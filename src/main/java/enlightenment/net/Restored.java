package enlightenment.net;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;

/**
 * What an earlier incarnation of the server had.
 *
 * @param tiles the tiles that are done, in their order
 * @param expelled machines that are not to be trusted
 */
record Restored(List<Tile> tiles, Set<String> expelled) {
    static final Restored NOTHING = new Restored(List.of(), Set.of());

    /** A tile: which machine made it, what it is, and whether another made the same. */
    record Tile(int tile, String machine, ContentHash hash, boolean confirmed) {}

    /** Puts it together from the records of a journal, in their order. */
    static final class Builder {
        private final Map<Integer, Tile> tiles = new TreeMap<>();
        private final Set<String> expelled = new LinkedHashSet<>();

        void add(JournalRecord record) {
            if (record instanceof JournalRecord.Kept kept) {
                kept(kept.tile(), kept.machine(), ContentHash.of(kept.data()));
            } else if (record instanceof JournalRecord.Confirmed confirmed) {
                tiles.computeIfPresent(
                        confirmed.tile(),
                        (tile, t) ->
                                t.hash().equals(confirmed.hash()) ? new Tile(tile, t.machine(), t.hash(), true) : t);
            } else if (record instanceof JournalRecord.Revoked revoked) {
                tiles.remove(revoked.tile());
            } else if (record instanceof JournalRecord.Expelled machine) {
                expelled.add(machine.machine());
            }
        }

        void kept(int tile, String machine, ContentHash hash) {
            tiles.put(tile, new Tile(tile, machine, hash, false));
        }

        /**
         * What is restored. The server may have died between an expulsion and the revocations that follow from it; so
         * what rests on the word of an expelled machine alone is left out.
         */
        Restored build() {
            List<Tile> trusted = new ArrayList<>();
            for (Tile tile : tiles.values()) {
                if (tile.confirmed() || !expelled.contains(tile.machine())) {
                    trusted.add(tile);
                }
            }
            return new Restored(List.copyOf(trusted), Set.copyOf(expelled));
        }
    }
}
