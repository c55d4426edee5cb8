/** The connection of a command and its terminal: streams, signals, exit codes, failures with one. */
package enlightenment.cli.terminal;
