/** The output of a finished picture: its file, its report, its exposure, and messages about it. */
package enlightenment.cli.picture;
