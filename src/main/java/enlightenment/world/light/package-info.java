/**
 * Lights as rendering reads them: emitting surfaces, points, the surroundings, what can occlude each, and how likely each is to be
 * chosen.
 */
package enlightenment.world.light;
