package enlightenment.net.schedule;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;

/** Which tiles are free, leased (once or twice) or done. Audits are not counted here: they are of tiles that are done. */
final class TileBoard {
    private final int tiles;
    private final BitSet free;
    private final BitSet done;
    private final Lease[] holder;
    private final Lease[] copier;
    private int freeCount;
    private int doneCount;
    private int offered;

    /** No free tile is below this one. */
    private int lowest;

    /** Leased tiles with one holder only. */
    private int single;

    /** @param offered tiles from this one on are not free before they are {@linkplain #offer offered} */
    TileBoard(int tiles, int offered) {
        this.tiles = tiles;
        this.offered = offered;
        free = new BitSet(tiles);
        free.set(0, offered);
        done = new BitSet(tiles);
        holder = new Lease[tiles];
        copier = new Lease[tiles];
        freeCount = offered;
    }

    /** The tiles before this one may be given away from now on. */
    void offer(int end) {
        for (int tile = offered; tile < end; tile++) {
            // It may have been restored.
            if (!done.get(tile) && !free.get(tile)) {
                setFree(tile);
            }
        }
        offered = Math.max(offered, end);
    }

    int tiles() {
        return tiles;
    }

    int free() {
        return freeCount;
    }

    int done() {
        return doneCount;
    }

    int undone() {
        return tiles - doneCount;
    }

    boolean isDone(int tile) {
        return done.get(tile);
    }

    /** Number of leased tiles that may be copied to another worker. */
    int copyable() {
        return single;
    }

    /** The lowest free tile; there must be one. */
    int nextFree() {
        lowest = free.nextSetBit(lowest);
        return lowest;
    }

    /** The end (excluded) of the free tiles from {@code first} on, at most {@code size} of them. */
    int endOfFree(int first, int size) {
        return Math.min(free.nextClearBit(first), first + Math.min(size, tiles - first));
    }

    /** The lease holds its tiles, which are free or held by one other lease. */
    void hold(Lease lease) {
        for (int tile = lease.first; tile < lease.last; tile++) {
            attach(tile, lease);
        }
    }

    private void attach(int tile, Lease lease) {
        if (holder[tile] == null) {
            holder[tile] = lease;
            free.clear(tile);
            freeCount--;
            addSingle(lease, 1);
        } else if (copier[tile] == null) {
            copier[tile] = lease;
            addSingle(holder[tile], -1);
        } else {
            throw new IllegalStateException("tile " + tile + " is held twice already");
        }
    }

    /** Removes the lease from its tiles; those that no other lease holds are free again. */
    void release(Lease lease) {
        for (int tile = lease.first; tile < lease.last; tile++) {
            if (holder[tile] == lease || copier[tile] == lease) {
                detach(tile, lease);
            }
        }
    }

    private void detach(int tile, Lease lease) {
        Lease other = holder[tile] == lease ? copier[tile] : holder[tile];
        holder[tile] = other;
        copier[tile] = null;
        if (other == null) {
            addSingle(lease, -1);
            setFree(tile);
        } else {
            addSingle(other, 1);
        }
    }

    private void setFree(int tile) {
        free.set(tile);
        freeCount++;
        lowest = Math.min(lowest, tile);
    }

    private void addSingle(Lease lease, int by) {
        lease.single += by;
        single += by;
    }

    /** The tile is done; returns the leases that held it. Nothing happens if it was done already. */
    List<Lease> finish(int tile) {
        List<Lease> holders = new ArrayList<>(2);
        if (done.get(tile)) {
            return holders;
        }
        done.set(tile);
        doneCount++;
        if (holder[tile] == null) {
            freeCount -= free.get(tile) ? 1 : 0;
            free.clear(tile);
            return holders;
        }
        holders.add(holder[tile]);
        if (copier[tile] == null) {
            addSingle(holder[tile], -1);
        } else {
            holders.add(copier[tile]);
        }
        holder[tile] = null;
        copier[tile] = null;
        return holders;
    }

    /** The tile, which is done, must be done again. */
    void undo(int tile) {
        done.clear(tile);
        doneCount--;
        setFree(tile);
    }

    /** The last run of tiles that only this lease holds, as {first, last}; null if there is none. */
    int[] lastSingles(Lease lease) {
        int last = lease.last;
        while (last > lease.first && !isSingle(last - 1, lease)) {
            last--;
        }
        int first = last;
        while (first > lease.first && isSingle(first - 1, lease)) {
            first--;
        }
        return first == last ? null : new int[] {first, last};
    }

    /** Takes a tile away from its lease, which must be its only holder; the tile is free then. */
    void takeFrom(Lease lease, int tile) {
        detach(tile, lease);
        lease.clear(tile);
    }

    private boolean isSingle(int tile, Lease lease) {
        return holder[tile] == lease && copier[tile] == null;
    }
}
