/**
 * The paper's cluster method for classic shading: a survey of the corners of pixels, samples allocated by it, and proposals for points of
 * lights.
 */
package enlightenment.classic.cluster;
