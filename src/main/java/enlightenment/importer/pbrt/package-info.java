/** Scenes of pbrt-v4 (M. Pharr, W. Jakob, G. Humphreys, "Physically Based Rendering", 4th edition; the format is described at pbrt.org). */
package enlightenment.importer.pbrt;
