/**
 * The trade of speed against accuracy, measured: a ladder of budgets for each method, judged against a converged reference,
 * fitted, and put into words. {@code docs/trade.md} explains it.
 */
package enlightenment.measure;
