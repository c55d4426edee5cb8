/**
 * Arithmetic that the rest is built on: sums of products without cancellation, exact decimals, powers of two, angles. Every
 * function states its error bound and uses only operations that all machines round alike.
 */
package enlightenment.numeric;
