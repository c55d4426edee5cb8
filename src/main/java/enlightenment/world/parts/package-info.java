/**
 * Foundations of all passes over a scene: its primitives as arrays in canonical order, the objects they came from, the extent of the scene,
 * and a tree of boxes.
 */
package enlightenment.world.parts;
