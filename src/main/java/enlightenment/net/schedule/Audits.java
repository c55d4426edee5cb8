package enlightenment.net.schedule;

import enlightenment.checkpoint.Origin;
import enlightenment.checkpoint.Restored;
import enlightenment.file.ContentHash;
import enlightenment.sampling.Hash;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.TreeMap;

/**
 * The votes of origins on tiles. Every result is a vote of its origin for a hash. A tile counts as done with its first vote; some tiles are
 * chosen to need a second one. Where two votes differ the server makes the tile itself, and its vote decides: a majority may be a single
 * machine under many names, which could otherwise have honest ones expelled.
 */
final class Audits {
    private final double rate;
    private final long salt;
    private final Vote[] kept;

    /** By tile: the second origin whose vote equals the kept one, or the server where it decided; null without one. */
    private final Origin[] second;

    private final Map<Integer, Open> open = new TreeMap<>();

    /** Tiles for which one word is not enough. */
    private final BitSet due = new BitSet();

    /** Open tiles that no member renders now. */
    private final Set<Integer> waiting = new LinkedHashSet<>();

    /** Open tiles that votes differ on. */
    private final Set<Integer> disputed = new LinkedHashSet<>();

    Audits(CoordinatorSettings settings) {
        rate = settings.auditRate();
        salt = settings.auditSalt();
        kept = new Vote[settings.tiles()];
        second = new Origin[settings.tiles()];
    }

    /** The vote of an origin that a tile has this hash. */
    record Vote(Origin origin, ContentHash hash) {
        boolean isServers() {
            return origin.equals(Origin.SERVER);
        }
    }

    /** A tile that needs another vote. */
    static final class Open {
        final int tile;
        final List<Vote> votes = new ArrayList<>();

        /** Whether the tile needs two votes even if no vote contradicts the first. */
        private final boolean isRequired;

        /** The lease that will bring the next vote, null if there is none. */
        Lease lease;

        Open(int tile, Vote first, boolean isRequired) {
            this.tile = tile;
            this.isRequired = isRequired;
            votes.add(first);
        }

        boolean isDisputed() {
            return votes.stream().map(Vote::hash).distinct().count() > 1;
        }

        Vote voteOf(Origin origin) {
            return votes.stream()
                    .filter(v -> v.origin.equals(origin))
                    .findFirst()
                    .orElse(null);
        }

        /** Whether a vote of the member would change the state of this tile. */
        boolean canBeVotedOnBy(WorkerState member) {
            return voteOf(member.origin) == null && (member.isServer() || !isDisputed());
        }
    }

    /**
     * The consequences of a vote.
     *
     * @param repeated this origin had cast an equal vote before
     * @param keep the data that came with the vote are the tile's result now
     * @param confirmedBy the origin whose vote agrees with the kept one; null if this vote confirmed nothing
     * @param liars origins that voted against the server, or against themselves
     * @param moot a lease for another vote that is not needed any more, or null
     */
    record Verdict(boolean repeated, boolean keep, Origin confirmedBy, List<Origin> liars, Lease moot) {
        private static final Verdict REPEATED = new Verdict(true, false, null, List.of(), null);
        private static final Verdict NOTHING = new Verdict(false, false, null, List.of(), null);
        private static final Verdict FIRST = new Verdict(false, true, null, List.of(), null);

        private static Verdict liar(Origin origin) {
            return new Verdict(false, false, null, List.of(origin), null);
        }
    }

    /** Whether the tile is one of those that are audited: a pure function of salt and tile. */
    static boolean isChosen(double rate, long salt, int tile) {
        return Hash.unit(Hash.of(salt, tile)) < rate;
    }

    private boolean isChosen(int tile) {
        return isChosen(rate, salt, tile);
    }

    /** A result from the journal. */
    void restore(Restored.Tile tile) {
        kept[tile.tile()] = new Vote(tile.origin(), tile.hash());
        second[tile.tile()] = tile.second();
        if (isChosen(tile.tile())) {
            due.set(tile.tile());
            if (tile.second() == null) {
                open(tile.tile(), true);
            }
        }
    }

    private Open open(int tile, boolean isRequired) {
        Open opened = new Open(tile, kept[tile], isRequired);
        if (second[tile] != null && !second[tile].equals(kept[tile].origin)) {
            opened.votes.add(new Vote(second[tile], kept[tile].hash));
        }
        open.put(tile, opened);
        waiting.add(tile);
        due.set(tile, due.get(tile) || isRequired);
        return opened;
    }

    /** @param isUnproven whether this vote alone is not enough in any case */
    Verdict vote(int tile, Origin origin, ContentHash hash, boolean isUnproven) {
        Vote mine = new Vote(origin, hash);
        Vote first = kept[tile];
        if (first == null) {
            kept[tile] = mine;
            if (isUnproven || isChosen(tile)) {
                open(tile, true);
            }
            return Verdict.FIRST;
        }
        Open opened = open.get(tile);
        Vote earlier = opened != null ? opened.voteOf(origin) : earlierOnClosed(tile, origin);
        if (earlier != null) {
            return earlier.hash.equals(hash) ? Verdict.REPEATED : Verdict.liar(origin);
        }
        if (opened != null) {
            return count(opened, mine);
        }
        if (!first.hash.equals(hash)) {
            return isServersWord(tile) && !mine.isServers()
                    ? Verdict.liar(origin)
                    : count(open(tile, isChosen(tile)), mine);
        }
        if (second[tile] != null) {
            return Verdict.NOTHING;
        }
        second[tile] = origin;
        return new Verdict(false, false, origin, List.of(), null);
    }

    private Vote earlierOnClosed(int tile, Origin origin) {
        boolean isKnown = kept[tile].origin.equals(origin) || origin.equals(second[tile]);
        return isKnown ? new Vote(origin, kept[tile].hash) : null;
    }

    private boolean isServersWord(int tile) {
        return kept[tile].isServers() || Origin.SERVER.equals(second[tile]);
    }

    private Verdict count(Open opened, Vote mine) {
        if (mine.isServers()) {
            return decide(opened, mine);
        }
        Vote servers = opened.voteOf(Origin.SERVER);
        if (servers != null && !servers.hash.equals(mine.hash)) {
            return Verdict.liar(mine.origin);
        }
        opened.votes.add(mine);
        if (opened.isDisputed()) {
            disputed.add(opened.tile);
            return Verdict.NOTHING;
        }
        second[opened.tile] = mine.origin;
        close(opened);
        return new Verdict(false, false, mine.origin, List.of(), opened.lease);
    }

    private Verdict decide(Open opened, Vote mine) {
        boolean replaced = !kept[opened.tile].hash.equals(mine.hash);
        if (replaced) {
            kept[opened.tile] = mine;
        }
        second[opened.tile] = Origin.SERVER;
        close(opened);
        List<Origin> liars = opened.votes.stream()
                .filter(v -> !v.hash.equals(mine.hash))
                .map(Vote::origin)
                .toList();
        return new Verdict(false, replaced, Origin.SERVER, liars, opened.lease);
    }

    private void close(Open opened) {
        open.remove(opened.tile);
        waiting.remove(opened.tile);
        disputed.remove(opened.tile);
    }

    /** The machine's votes count no longer. Returns the tiles that rest on its word alone and must be done again. */
    List<Integer> expel(Origin.Peer machine) {
        List<Integer> lost = new ArrayList<>();
        for (int tile = 0; tile < kept.length; tile++) {
            if (kept[tile] == null) {
                continue;
            }
            Restored.Tile left =
                    new Restored.Tile(tile, kept[tile].origin, kept[tile].hash, second[tile]).without(machine);
            boolean wasConfirmed = second[tile] != null;
            kept[tile] = left == null ? null : new Vote(left.origin(), left.hash());
            second[tile] = left == null ? null : left.second();
            if (left == null) {
                lost.add(tile);
            } else if (wasConfirmed && second[tile] == null && isChosen(tile) && !open.containsKey(tile)) {
                open(tile, true);
            }
        }
        List.copyOf(open.values()).forEach(opened -> forget(opened, machine));
        return lost;
    }

    private void forget(Open opened, Origin.Peer machine) {
        if (kept[opened.tile] == null) {
            // The others' votes go too: their data were not kept, so the tile starts afresh.
            close(opened);
        } else if (opened.votes.removeIf(v -> v.origin.equals(machine)) && !opened.isDisputed()) {
            disputed.remove(opened.tile);
            if (second[opened.tile] == null) {
                Origin first = kept[opened.tile].origin;
                second[opened.tile] = opened.votes.stream()
                        .map(Vote::origin)
                        .filter(o -> !o.equals(first))
                        .findFirst()
                        .orElse(null);
            }
            if (second[opened.tile] != null || !opened.isRequired) {
                close(opened);
            }
        }
    }

    /** The tile starts afresh. Returns the lease that would have brought another vote, or null. */
    Lease forget(int tile) {
        Open opened = open.get(tile);
        if (opened != null) {
            close(opened);
        }
        kept[tile] = null;
        second[tile] = null;
        return opened == null ? null : opened.lease;
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

    /** The first tile that votes differ on; null if there is none. */
    Integer firstDisputed() {
        return disputed.isEmpty() ? null : disputed.iterator().next();
    }

    /** The tiles that are audited, in ascending order: without those of the server's own, whose word is enough. */
    List<Integer> due() {
        return due.stream()
                .filter(tile -> kept[tile] != null && (second[tile] != null || !kept[tile].isServers()))
                .boxed()
                .toList();
    }

    /** The {@link #due} tiles whose result rests on one machine. */
    List<Integer> missing() {
        return due().stream().filter(tile -> second[tile] == null).toList();
    }

    int openCount() {
        return open.size();
    }

    int confirmedCount() {
        return (int) Arrays.stream(second).filter(Objects::nonNull).count();
    }

    /** The first few open tiles that no member renders; those returned come last next time. */
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
