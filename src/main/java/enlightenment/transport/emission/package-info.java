/** Samples the start of light paths: a light, a point on it and a direction. */
package enlightenment.transport.emission;
