/**
 * What a measurement of speed against accuracy is asked and what it answers: settings, timed renders, the reference and the
 * advice. {@link enlightenment.measure.Trade} makes it.
 */
package enlightenment.measure.trade;
