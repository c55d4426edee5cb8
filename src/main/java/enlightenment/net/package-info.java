/**
 * Many machines, one picture: a server that hands out tile columns and workers that render them.
 *
 * <p>{@link enlightenment.net.RenderServer} and {@link enlightenment.net.RenderWorker} are the two sides; {@link
 * enlightenment.net.RenderParts} does the same by files, for job arrays.
 *
 * <p>Everything that decides is free of clocks, sockets and threads, so that it can be simulated: {@code Coordinator} (who
 * renders what), {@code WorkerCore} (what a worker holds and owes), {@code CheckpointJournal} (what survives), {@code Frames} and
 * {@code Message} (what is said), {@code Handshake} (who may say it). docs/distributed-protocol.md describes the protocol.
 */
package enlightenment.net;
