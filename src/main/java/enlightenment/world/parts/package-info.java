/**
 * What every pass over a scene stands on: its primitives as arrays in a canonical order, the objects they came from, the extent of
 * the scene, and a tree over boxes.
 */
package enlightenment.world.parts;
