/**
 * The frame that a scene is rendered in, and geometry in it: boxes, rotations, the cone around a ball. Exact points become doubles here,
 * once and with one rounding.
 */
package enlightenment.frame;
