/** A worker's side: its sessions with a server, the contents that it fetches, and the threads that render. */
package enlightenment.net.worker;
