/** The settings of a render as options, and in the one line that makes the same picture again. */
package enlightenment.cli.setting;
