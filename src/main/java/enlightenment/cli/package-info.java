/** The command line: where it begins, and all commands by name. Nothing outside of these packages prints or ends the process. */
package enlightenment.cli;
