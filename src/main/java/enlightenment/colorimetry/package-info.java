/** Wavelengths and what the eye makes of them: sensitivities of bands, indices of refraction, the curve of screens. */
package enlightenment.colorimetry;
