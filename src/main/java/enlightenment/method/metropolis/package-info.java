/**
 * Method {@code metropolis}: Markov chains in primary sample space that live in blocks of the picture (docs/notes/metropolis.md). Internal.
 */
package enlightenment.method.metropolis;
