/**
 * What one camera ray is worth: the paper's cosine shading, mirrors, nested glass, and the sampling of lights. Every random
 * number is a pure function of a {@link enlightenment.shading.SampleAddress}.
 */
package enlightenment.shading;
