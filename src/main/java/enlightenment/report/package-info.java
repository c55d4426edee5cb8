/** What is told of a render that is over: {@link enlightenment.report.RenderReport}, numbers and words only. */
package enlightenment.report;
