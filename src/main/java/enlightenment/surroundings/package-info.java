/** Light from all directions: pictures of them, sun and sky, and choosing directions by what comes from there. */
package enlightenment.surroundings;
