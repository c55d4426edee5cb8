/** The command line: one class per command. Nothing else in Enlightenment prints or ends the process. */
package enlightenment.cli;
