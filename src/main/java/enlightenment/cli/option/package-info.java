/** What options and parameters are made of: converters of values, files, rules, and what all commands have in common. */
package enlightenment.cli.option;
