/**
 * The state of renders that survives the end of a process. A journal has the results of units, the plans that they are of, and the machines
 * that are not trusted. A render in one process keeps it as {@link enlightenment.checkpoint.Checkpoint}; a server, which has to record the
 * origins of results, writes the same file itself.
 */
package enlightenment.checkpoint;
