package enlightenment.net;

import enlightenment.sampling.Hash;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;

/**
 * Who said what about which tile. Every result is a vote of a machine for a hash. A tile counts with its first vote;
 * some tiles are chosen to need a second one, and a tile on which votes differ stays open until two votes agree. Then
 * whoever voted otherwise is a liar. The server's own vote decides alone.
 */
final class Audits {
    private final double rate;
    private final long salt;
    private final Vote[] kept;
    private final BitSet confirmed;
    private final Map<Integer, Open> open = new TreeMap<>();

    /** Open tiles that nobody renders now. */
    private final Set<Integer> waiting = new LinkedHashSet<>();

    Audits(CoordinatorSettings settings) {
        rate = settings.auditRate();
        salt = settings.auditSalt();
        kept = new Vote[settings.tiles()];
        confirmed = new BitSet(settings.tiles());
    }

    /** What a machine says that a tile is. */
    record Vote(String machine, ContentHash hash) {
        boolean isLocal() {
            return machine.equals(Coordinator.LOCAL);
        }
    }

    /** A tile that needs another vote. */
    static final class Open {
        final int tile;
        final List<Vote> votes = new ArrayList<>();

        /** The lease that will bring the next vote, null if there is none. */
        Lease lease;

        Open(int tile, Vote first) {
            this.tile = tile;
            votes.add(first);
        }

        boolean isDisputed() {
            return votes.stream().map(Vote::hash).distinct().count() > 1;
        }

        Vote voteOf(String machine) {
            return votes.stream()
                    .filter(v -> v.machine.equals(machine))
                    .findFirst()
                    .orElse(null);
        }
    }

    /**
     * What a vote changed.
     *
     * @param repeated the same machine had said the same before
     * @param keep the data that came with the vote are the tile's result now
     * @param confirmed two machines agree now
     * @param liars who voted against those two, or against itself
     * @param moot a lease for another vote that is not needed any more, or null
     */
    record Verdict(boolean repeated, boolean keep, boolean confirmed, List<String> liars, Lease moot) {
        private static final Verdict REPEATED = new Verdict(true, false, false, List.of(), null);
        private static final Verdict NOTHING = new Verdict(false, false, false, List.of(), null);
        private static final Verdict FIRST = new Verdict(false, true, false, List.of(), null);
        private static final Verdict CONFIRMED = new Verdict(false, false, true, List.of(), null);

        private static Verdict liar(String machine) {
            return new Verdict(false, false, false, List.of(machine), null);
        }
    }

    /** Whether the tile is one of those that are audited: a pure function of salt and tile. */
    static boolean isChosen(double rate, long salt, int tile) {
        return Hash.unit(Hash.of(salt, tile)) < rate;
    }

    /** A result from the journal. */
    void restore(int tile, Vote vote, boolean isConfirmed) {
        kept[tile] = vote;
        confirmed.set(tile, isConfirmed);
        if (!isConfirmed && isChosen(rate, salt, tile)) {
            open(tile, vote);
        }
    }

    private Open open(int tile, Vote vote) {
        Open opened = new Open(tile, vote);
        open.put(tile, opened);
        waiting.add(tile);
        return opened;
    }

    Verdict vote(int tile, String machine, ContentHash hash) {
        Vote mine = new Vote(machine, hash);
        Vote first = kept[tile];
        if (first == null) {
            kept[tile] = mine;
            if (isChosen(rate, salt, tile)) {
                open(tile, mine);
            }
            return Verdict.FIRST;
        }
        Open opened = open.get(tile);
        Vote earlier = opened != null ? opened.voteOf(machine) : first.machine.equals(machine) ? first : null;
        if (earlier != null) {
            return earlier.hash.equals(hash) ? Verdict.REPEATED : Verdict.liar(machine);
        }
        if (opened == null) {
            return voteOnClosed(tile, first, mine);
        }
        return count(opened, mine);
    }

    private Verdict voteOnClosed(int tile, Vote first, Vote mine) {
        if (first.hash.equals(mine.hash)) {
            boolean isNew = !confirmed.get(tile);
            confirmed.set(tile);
            return isNew ? Verdict.CONFIRMED : Verdict.NOTHING;
        }
        if ((confirmed.get(tile) || first.isLocal()) && !mine.isLocal()) {
            return Verdict.liar(mine.machine);
        }
        return count(open(tile, first), mine);
    }

    private Verdict count(Open opened, Vote mine) {
        boolean agreed = mine.isLocal() || opened.votes.stream().anyMatch(v -> v.hash.equals(mine.hash));
        if (!agreed && opened.voteOf(Coordinator.LOCAL) != null) {
            return Verdict.liar(mine.machine);
        }
        opened.votes.add(mine);
        if (!agreed) {
            return Verdict.NOTHING;
        }
        boolean replaced = !kept[opened.tile].hash.equals(mine.hash);
        if (replaced) {
            kept[opened.tile] = mine;
        }
        confirmed.set(opened.tile);
        close(opened);
        List<String> liars = opened.votes.stream()
                .filter(v -> !v.hash.equals(mine.hash))
                .map(Vote::machine)
                .toList();
        return new Verdict(false, replaced, true, liars, opened.lease);
    }

    private void close(Open opened) {
        open.remove(opened.tile);
        waiting.remove(opened.tile);
    }

    /** The machine's votes count no longer. Returns the tiles that rest on its word alone and must be done again. */
    List<Integer> expel(String machine) {
        List<Integer> lost = new ArrayList<>();
        for (int tile = 0; tile < kept.length; tile++) {
            if (kept[tile] != null && kept[tile].machine.equals(machine) && !confirmed.get(tile)) {
                kept[tile] = null;
                lost.add(tile);
            }
        }
        for (Open opened : List.copyOf(open.values())) {
            if (kept[opened.tile] == null) {
                // The others' votes go too: their data were not kept, so the tile starts afresh.
                close(opened);
            } else if (opened.votes.removeIf(v -> v.machine.equals(machine))
                    && opened.votes.size() == 1
                    && !isChosen(rate, salt, opened.tile)) {
                close(opened);
            }
        }
        return lost;
    }

    /** A lease will bring the next vote on this tile. */
    void lease(Open opened, Lease lease) {
        opened.lease = lease;
        waiting.remove(opened.tile);
    }

    /** The lease will bring nothing. */
    void release(Lease lease) {
        Open opened = open.get(lease.first);
        if (opened != null && opened.lease == lease) {
            opened.lease = null;
            waiting.add(opened.tile);
        }
    }

    /** The open tile with this number, or null. */
    Open open(int tile) {
        return open.get(tile);
    }

    /** All open tiles. */
    List<Open> open() {
        return List.copyOf(open.values());
    }

    int openCount() {
        return open.size();
    }

    int confirmedCount() {
        return confirmed.cardinality();
    }

    /** The first few open tiles that nobody renders; those seen come last next time. */
    List<Open> someWaiting(int most) {
        List<Open> some = new ArrayList<>();
        for (Integer tile : waiting) {
            if (some.size() == most) {
                break;
            }
            some.add(open.get(tile));
        }
        for (Open opened : some) {
            waiting.remove(opened.tile);
            waiting.add(opened.tile);
        }
        return some;
    }
}
