/**
 * The cluster method for physical light, with path reuse between pixels, and the parts that it shares with the classic one: visible blocks,
 * their limits, and the search for an effort.
 */
package enlightenment.method.cluster;
