/**
 * Random numbers as pure functions of their address, low-discrepancy sequences, the proposal distributions of ray clusters, and running
 * statistics. A path reads its numbers from a {@link enlightenment.sampling.Sampler} by address; no state depends on the order of calls or
 * the number of threads.
 */
package enlightenment.sampling;
