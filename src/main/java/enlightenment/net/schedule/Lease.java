package enlightenment.net.schedule;

import java.util.BitSet;

/** Tiles that a worker was asked for, and which of them it still owes. */
final class Lease {
    /** Why it was granted. */
    enum Kind {
        WORK,
        /** Undone tiles of another lease, at the end of a job. */
        COPY,
        /** A tile that is done and is rendered again to compare. */
        AUDIT
    }

    final long id;
    final WorkerState member;
    final int first;
    final int last;
    final Kind kind;

    /** When it was granted or last named by its holder. */
    long renewed;

    /** No longer waited for; its tiles were given back. */
    boolean stalled;

    /** Number of its tiles that no other lease holds. */
    int single;

    private final BitSet owed;
    private int owedCount;

    Lease(long id, WorkerState member, int first, int last, Kind kind, long now) {
        this.id = id;
        this.member = member;
        this.first = first;
        this.last = last;
        this.kind = kind;
        renewed = now;
        owed = new BitSet(last - first);
        owed.set(0, last - first);
        owedCount = last - first;
    }

    boolean owes(int tile) {
        return tile >= first && tile < last && owed.get(tile - first);
    }

    /** Number of tiles still owed. */
    int owed() {
        return owedCount;
    }

    /** The tile is no longer owed; returns whether it was. */
    boolean clear(int tile) {
        if (!owes(tile)) {
            return false;
        }
        owed.clear(tile - first);
        owedCount--;
        return true;
    }
}
