/**
 * Descriptions of shapes, in scene coordinates: immutable records, exact and validated when they are made. They know nothing
 * of rays; the renderer places them in its own frame.
 */
package enlightenment.geometry;
