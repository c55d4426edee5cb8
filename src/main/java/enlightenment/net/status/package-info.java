/** How far a server is, shown on loopback: a page, the picture so far, and JSON. */
package enlightenment.net.status;
