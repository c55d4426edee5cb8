/** Analysis of timed renders: curves, power laws, costs of errors, comparisons, and advice in words. Nothing is measured here. */
package enlightenment.measure.analysis;
