package enlightenment.net.schedule;

import enlightenment.checkpoint.Origin;
import enlightenment.net.job.TileData;

/** What a {@link Coordinator} wants done, in this order. */
public sealed interface Action {
    /** Tell the worker to render the tiles {@code first} (included) to {@code last} (excluded). */
    record Grant(long worker, long lease, int first, int last) implements Action {}

    /** Tell the worker that what it has not begun of the lease is not wanted. */
    record Cancel(long worker, long lease) implements Action {}

    /** Tell the worker that it may skip the tiles {@code first} (included) to {@code last} (excluded). */
    record Skip(long worker, long lease, int first, int last) implements Action {}

    /** Answer a heartbeat. */
    record Answer(long worker, int done) implements Action {}

    /** Tell the worker that its tile has arrived; to be done after the keeping, which comes before it. */
    record Acknowledge(long worker, int tile) implements Action {}

    /** These are the sums of this tile now; write them to the journal and into the picture, over older ones. */
    record Keep(int tile, Origin origin, TileData data) implements Action {}

    /** Somebody else says the same of this tile, or the server has decided it; write that to the journal. */
    record Confirm(int tile, Origin by) implements Action {}

    /** What was kept of this tile is not to be trusted; write that to the journal and take it out of the picture. */
    record Revoke(int tile) implements Action {}

    /** Close the connection and tell why; the worker may come back. */
    record HangUp(long worker, String reason) implements Action {}

    /**
     * This machine is not to be trusted: write that to the journal and refuse it from now on. Its connections follow as
     * {@link Refuse}.
     */
    record Expel(Origin.Peer machine, String reason) implements Action {}

    /** Close the connection and tell why; the worker is not to come back. */
    record Refuse(long worker, String reason) implements Action {}

    /**
     * Votes differ on this tile: let the server itself join as a worker, whose word decides. Said again with every event
     * until it has.
     */
    record CallLocal(int tile) implements Action {}

    /** Everything is done. */
    record Finish() implements Action {}
}
