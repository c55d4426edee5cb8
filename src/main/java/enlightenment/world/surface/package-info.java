/** The interaction of a path with a surface, made from a hit in one place. */
package enlightenment.world.surface;
