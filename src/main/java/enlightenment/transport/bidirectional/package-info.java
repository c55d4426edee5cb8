/** Bidirectional path tracing: subpaths that know their densities, and their connections. */
package enlightenment.transport.bidirectional;
