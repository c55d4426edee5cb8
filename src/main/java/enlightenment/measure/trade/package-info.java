/**
 * Settings and results of a measurement of speed against accuracy: timed renders, the reference and the advice.
 * {@link enlightenment.measure.Trade} runs it.
 */
package enlightenment.measure.trade;
