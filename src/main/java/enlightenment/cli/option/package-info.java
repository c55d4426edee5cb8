/** The parts of options and parameters: converters of values, files, rules, and the base of all commands. */
package enlightenment.cli.option;
