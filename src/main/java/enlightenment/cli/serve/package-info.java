/** The commands for server and workers, and what {@code animate} has of them. */
package enlightenment.cli.serve;
