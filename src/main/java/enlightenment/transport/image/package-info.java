/** Images of small lamps as seen from the eye or from a vertex, directly or in mirrors, and sampling of directions within them. */
package enlightenment.transport.image;
