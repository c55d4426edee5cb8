/** What shading knows of the surface that a ray has met: made from a hit in one place. */
package enlightenment.world.surface;
