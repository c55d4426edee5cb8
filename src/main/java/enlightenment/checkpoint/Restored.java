package enlightenment.checkpoint;

import enlightenment.file.ContentHash;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;

/**
 * The state of an earlier incarnation of the server.
 *
 * @param tiles the tiles that are done, in their order
 * @param expelled machines that are not to be trusted
 */
public record Restored(List<Tile> tiles, Set<Origin.Peer> expelled) {
    public static final Restored NOTHING = new Restored(List.of(), Set.of());

    /**
     * A finished tile.
     *
     * @param origin the maker of its result
     * @param hash that of the result
     * @param second another origin with an equal result; null without one
     */
    public record Tile(int tile, Origin origin, ContentHash hash, Origin second) {
        /** The tile without the results of a machine; null if no origin remains. */
        public Tile without(Origin.Peer machine) {
            if (origin.equals(machine)) {
                return second == null ? null : new Tile(tile, second, hash, null);
            }
            return machine.equals(second) ? new Tile(tile, origin, hash, null) : this;
        }
    }

    /** Puts it together from the records of a journal, in their order. */
    public static final class Builder {
        private final Map<Integer, Tile> tiles = new TreeMap<>();
        private final Set<Origin.Peer> expelled = new LinkedHashSet<>();

        public void add(JournalRecord record) {
            if (record instanceof JournalRecord.Kept kept) {
                kept(kept.tile(), kept.origin(), ContentHash.of(kept.data()));
            } else if (record instanceof JournalRecord.Confirmed confirmed) {
                tiles.computeIfPresent(
                        confirmed.tile(),
                        (tile, t) -> t.hash().equals(confirmed.hash())
                                ? new Tile(tile, t.origin(), t.hash(), confirmed.by())
                                : t);
            } else if (record instanceof JournalRecord.Revoked revoked) {
                tiles.remove(revoked.tile());
            } else if (record instanceof JournalRecord.Expelled e) {
                expelled.add(e.machine());
                // The server may have died before the revocations that follow from it.
                List.copyOf(tiles.keySet())
                        .forEach(tile -> tiles.computeIfPresent(tile, (n, t) -> t.without(e.machine())));
            } else if (record instanceof JournalRecord.Pardoned pardoned) {
                expelled.remove(pardoned.machine());
            }
        }

        public void kept(int tile, Origin origin, ContentHash hash) {
            tiles.put(tile, new Tile(tile, origin, hash, null));
        }

        public Restored build() {
            return new Restored(List.copyOf(tiles.values()), Set.copyOf(expelled));
        }
    }
}
