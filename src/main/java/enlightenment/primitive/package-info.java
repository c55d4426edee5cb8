/**
 * Shapes placed in the scene's frame, and rays that intersect them: robust forms with error bounds, no scale constants, no allocation per
 * test. {@link enlightenment.primitive.Primitives#place} makes a primitive of a shape.
 */
package enlightenment.primitive;
