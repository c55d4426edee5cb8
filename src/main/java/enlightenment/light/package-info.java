/** Descriptions of lights, in scene coordinates: immutable records, exact and validated when they are made. */
package enlightenment.light;
