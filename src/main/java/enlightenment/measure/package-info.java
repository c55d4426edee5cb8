/**
 * Measures speed: {@link enlightenment.measure.Bench} of one setting, {@link enlightenment.measure.Trade} against accuracy, for each
 * method over a series of budgets and against a converged reference. {@code docs/notes/trade.md} explains how.
 */
package enlightenment.measure;
