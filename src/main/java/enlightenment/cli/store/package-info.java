/** The commands and options for renders in databases. */
package enlightenment.cli.store;
