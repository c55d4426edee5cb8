/** What is to be seen of a render while it goes on: bars, previews, a page, a window. */
package enlightenment.cli.progress;
