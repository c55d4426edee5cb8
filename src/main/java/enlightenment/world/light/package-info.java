/**
 * Lights as rendering reads them: emitting surfaces, point lights and surroundings, the possible occluders of each, and the distributions
 * that sample them.
 */
package enlightenment.world.light;
