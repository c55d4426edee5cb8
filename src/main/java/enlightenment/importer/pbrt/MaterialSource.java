package enlightenment.importer.pbrt;

/**
 * A material as it stands in the file: a definition, or the name of one.
 *
 * @param type such as {@code coateddiffuse}; {@code ""} if it is named
 * @param name of a material that the file defines; {@code ""} if it is defined here
 * @param space of its rgb values
 */
record MaterialSource(String type, String name, Parameters parameters, ColorSpace space) {
    static MaterialSource named(String name, Place place) {
        return new MaterialSource("", name, new Parameters(place), ColorSpace.SRGB);
    }
}
