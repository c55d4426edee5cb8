package enlightenment.geometry;

import enlightenment.math.ExactPoint;
import java.util.List;

/**
 * What a thing's surface is: a description in scene coordinates, exact, validated when it is made.
 *
 * <p>A constructor refuses a degenerate shape with a {@link enlightenment.math.InvalidValueException} that names
 * the offending key.
 */
public sealed interface Shape permits Sphere, Rectangle, Disk, Cylinder, Cone, Cube, Box, Torus, Triangle {

    /** The name of this kind of shape in the scene format, such as {@code "sphere"}. */
    String type();

    /** Points whose coordinates give the shape's position; with {@link #reach}, they bound it. */
    List<ExactPoint> anchors();

    /** No point of the shape is farther than this from its nearest anchor's convex hull. */
    double reach();
}
