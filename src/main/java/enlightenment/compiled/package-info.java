/**
 * A scene made ready for rendering: flat arrays in a canonical order, only what the scene requires. Here it is decided which
 * surfaces coincide, which primitives can occlude a light, and what a ray meets; what a ray is worth is decided in
 * {@code shading}.
 */
package enlightenment.compiled;
