/** Free flight in media: distances to the next collision, by transmittance or by the angle under which a light is seen. */
package enlightenment.transport.media;
