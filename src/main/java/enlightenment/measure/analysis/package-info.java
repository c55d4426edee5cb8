/** What timed renders show: curves, power laws, the cost of an error, comparisons, and advice in words. Measures nothing itself. */
package enlightenment.measure.analysis;
