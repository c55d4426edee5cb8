/** Scene files as commands name them: how they are read, which frames they have, and what is said of anything that fails. */
package enlightenment.cli.input;
