/** The command that renders animations, as files of frames or as a video. */
package enlightenment.cli.film;
