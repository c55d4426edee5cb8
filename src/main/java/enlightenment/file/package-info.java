/** Files that appear as a whole or not at all, what is left of them when a process is killed, and whether two paths are one file. */
package enlightenment.file;
