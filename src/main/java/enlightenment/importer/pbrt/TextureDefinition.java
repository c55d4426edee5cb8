package enlightenment.importer.pbrt;

/**
 * A texture as it stands in the file.
 *
 * @param type such as {@code imagemap}
 * @param space of its rgb values
 */
record TextureDefinition(String type, Parameters parameters, ColorSpace space) {}
