/**
 * Who renders what, decided on both sides without clocks, sockets or threads, so that whole renders can be simulated.
 *
 * <p>{@code Coordinator} decides for the server: its {@code Dispatcher} sizes and grants leases, {@code Audits} has some tiles
 * rendered by a second machine. {@code WorkerCore} is what a worker holds and owes.
 */
package enlightenment.net.schedule;
