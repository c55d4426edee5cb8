/**
 * The scheduling of tiles, on both sides without clocks, sockets or threads, so that whole renders can be simulated.
 *
 * <p>{@code Coordinator} decides for the server: its {@code Dispatcher} sizes and grants leases, {@code Audits} has some tiles rendered by
 * a second machine. {@code WorkerCore} has the leases and results of a worker.
 */
package enlightenment.net.schedule;
