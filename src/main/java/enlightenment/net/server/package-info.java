/** A server's side of its connections, its own rendering threads, and the job that it assembles. */
package enlightenment.net.server;
