/** Small lamps as they are seen from a vertex, straight or over specular surfaces, and directions chosen within their images. */
package enlightenment.transport.image;
