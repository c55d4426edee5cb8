/**
 * Removes grain from finished pictures of linear light: {@link enlightenment.denoise.Denoiser} is a pure function of {@link
 * enlightenment.denoise.NoisyPicture}, which has what a render knows of each pixel. Internal.
 */
package enlightenment.denoise;
