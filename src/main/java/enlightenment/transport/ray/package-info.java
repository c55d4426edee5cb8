/**
 * From one surface to the next: the media that a path is in, glass and its dispersion, borders that rays miss by rounding, and
 * shadow rays through what transmits light.
 */
package enlightenment.transport.ray;
