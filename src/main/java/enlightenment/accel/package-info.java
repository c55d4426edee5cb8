/**
 * The bounding volume hierarchy: built by the surface area heuristic, traversed without allocation. Its results are those of a loop over
 * all primitives, bit for bit.
 */
package enlightenment.accel;
