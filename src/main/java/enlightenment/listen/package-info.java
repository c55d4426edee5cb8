/** Servers for untrusted clients: a listening port, a bounded number of connections, and a rate-limited log. */
package enlightenment.listen;
