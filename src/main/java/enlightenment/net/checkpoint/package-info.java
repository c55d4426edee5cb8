/** What survives the end of a server: a journal of the tiles that are done, and of the machines that are not trusted. */
package enlightenment.net.checkpoint;
