/** Bidirectional path tracing: subpaths with their densities, and connections between them. */
package enlightenment.transport.bidirectional;
