/** Reports of renders that are over: {@link enlightenment.report.RenderReport}, numbers and words only. */
package enlightenment.report;
