/**
 * Rays from one surface to the next: the stack of media, glass and its dispersion, interfaces that rays miss by rounding, and shadow rays
 * through transmitting surfaces.
 */
package enlightenment.transport.ray;
