package enlightenment.cli.scene;

import enlightenment.math.Vec3;

/**
 * An upright cylinder in a template that a model has to fit into.
 *
 * @param foot the middle of its base, on what the model stands on; in scene units, with y upwards
 * @param radius so that a model can turn
 * @param material the name of the material that the template has for it
 */
record ModelPlace(Vec3 foot, double radius, double height, String material) {}
