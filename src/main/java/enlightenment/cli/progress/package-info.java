/** The displays of a render while it runs: bars, previews, a page, a window. */
package enlightenment.cli.progress;
