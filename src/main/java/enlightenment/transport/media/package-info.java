/** Distance sampling in media: free flights by transmittance, and equiangular sampling towards a light. */
package enlightenment.transport.media;
