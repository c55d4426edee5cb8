/** Scattering functions of surfaces and media: value, samples and density, a class for each kind. Internal. */
package enlightenment.bsdf;
