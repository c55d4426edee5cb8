/**
 * The forms of lights: points on them as seen from somewhere, the densities with which these are sampled, and what is known of a
 * light in closed form. One class for each form. Internal.
 */
package enlightenment.emitter;
