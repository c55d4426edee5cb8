/** What becomes of a finished picture: its file, its report, how it is shown, what is to be said of it. */
package enlightenment.cli.picture;
