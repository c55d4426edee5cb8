/** The commands that measure: pictures against references, methods against each other, the machine. */
package enlightenment.cli.measure;
