/** Paths from lights whose vertices are connected to the eye. */
package enlightenment.transport.light;
