/**
 * The cluster method for physical light, with paths that pixels share, and what the classic one has in common with it: blocks that show
 * something, their limits, and the search for an effort.
 */
package enlightenment.method.cluster;
