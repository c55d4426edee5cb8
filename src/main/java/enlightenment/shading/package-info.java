/**
 * What one camera ray is worth: following a path through surfaces and nested glass, and the paper's cosine shading. Every random
 * number comes from a {@link enlightenment.sampling.Sampler}.
 */
package enlightenment.shading;
