/** The path tracer of physical light, from the eye. */
package enlightenment.transport.path;
