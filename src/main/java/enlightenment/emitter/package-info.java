/**
 * The forms of lights: sampling of points on them, the densities of these samples, and closed forms of irradiance. A class for each form.
 * Internal.
 */
package enlightenment.emitter;
