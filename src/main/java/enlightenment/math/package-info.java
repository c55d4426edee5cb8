/**
 * The numbers of a scene description: exact points, vectors of doubles, and the exception for a value that cannot be used.
 * A point of a scene is an {@link enlightenment.math.ExactPoint}, exactly as written; a direction is a
 * {@link enlightenment.math.Vec3}.
 */
package enlightenment.math;
