/** The command {@code view}. */
package enlightenment.cli.view;
