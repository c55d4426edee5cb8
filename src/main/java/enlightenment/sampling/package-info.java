/**
 * Random numbers as pure functions of what is sampled, low-discrepancy sequences, the proposal distributions of ray clusters,
 * and running statistics. No function keeps a state that the order of calls or the number of threads could change.
 */
package enlightenment.sampling;
