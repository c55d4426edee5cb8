package enlightenment.importer.pbrt;

import enlightenment.importer.support.Affine;

/**
 * A shape as it stands in the file, with the state that counts for it.
 *
 * @param form the shape in coordinates of its own
 * @param map to the world, or to the object that it is a part of
 * @param isReversed whether ReverseOrientation holds
 * @param parameters its own
 * @param areaLight the parameters of the light that it is; null if it is none
 * @param insideMedium the medium inside; {@code ""} for none
 */
record ShapeDefinition(
        Form form,
        Affine map,
        boolean isReversed,
        Parameters parameters,
        MaterialSource material,
        Parameters areaLight,
        ColorSpace areaLightSpace,
        String insideMedium) {}
