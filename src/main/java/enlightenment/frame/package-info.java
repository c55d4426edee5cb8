/**
 * The frame that a scene is rendered in, and what is measured there: boxes, rotations, the cone in which a ball is seen. Exact
 * points become doubles here, once and with one rounding.
 */
package enlightenment.frame;
