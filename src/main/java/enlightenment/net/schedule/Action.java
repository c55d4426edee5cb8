package enlightenment.net.schedule;

import enlightenment.checkpoint.Origin;
import enlightenment.net.job.TileData;

/** An action that a {@link Coordinator} demands; the actions of an event are to be done in order. */
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

    /** Write the result to the journal and into the picture, in place of an older one of the tile. */
    record Keep(int tile, Origin origin, TileData data) implements Action {}

    /** Write to the journal that a second origin has an equal result, or that the server has decided. */
    record Confirm(int tile, Origin by) implements Action {}

    /** Write to the journal that the tile's result is not trusted, and take it out of the picture. */
    record Revoke(int tile) implements Action {}

    /** Close the connection and tell why; the worker may come back. */
    record HangUp(long worker, String reason) implements Action {}

    /**
     * Write to the journal that the machine is not trusted, and refuse it from now on. Its connections follow as {@link Refuse}.
     */
    record Expel(Origin.Peer machine, String reason) implements Action {}

    /** Close the connection and tell why; the worker is not to come back. */
    record Refuse(long worker, String reason) implements Action {}

    /**
     * Votes differ on this tile: let the server itself join as a worker, whose vote decides. Repeated with every event until it has joined.
     */
    record CallLocal(int tile) implements Action {}

    /** Everything is done. */
    record Finish() implements Action {}
}
