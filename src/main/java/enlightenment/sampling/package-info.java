/**
 * Random numbers as pure functions of what is sampled, low-discrepancy sequences, the proposal distributions of ray clusters,
 * and running statistics. What a path gets is a {@link enlightenment.sampling.Sampler}'s answer to an address; nothing keeps a state
 * that the order of questions or the number of threads could change.
 */
package enlightenment.sampling;
