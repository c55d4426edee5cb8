/** The paper's shading: cosine lighting by points and surfaces of light, mirrors and glass. */
package enlightenment.classic.shading;
