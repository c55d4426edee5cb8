/** The commands for scene files that render nothing. */
package enlightenment.cli.scene;
