/** What a command and its terminal have between them: streams, signals, exit codes, failures that name one. */
package enlightenment.cli.terminal;
