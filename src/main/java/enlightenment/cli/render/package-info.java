/** The commands that render a picture, and merge one from parts. */
package enlightenment.cli.render;
