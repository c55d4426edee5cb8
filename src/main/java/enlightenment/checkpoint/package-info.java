/**
 * What survives the end of a process: a journal of the results of units, of the plans that they are of, and of the machines that are not
 * trusted. A render in one process keeps it as {@link enlightenment.checkpoint.Checkpoint}; a server, which has to know whose word a result
 * is, writes the same file itself.
 */
package enlightenment.checkpoint;
