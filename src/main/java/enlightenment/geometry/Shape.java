package enlightenment.geometry;

import enlightenment.math.ExactPoint;
import java.util.List;

/**
 * The geometry of an object, such as a sphere, a box or a mesh: an immutable description in scene coordinates, validated when it is made.
 *
 * <p>The constructors throw {@link enlightenment.math.InvalidValueException}, with the key of the scene format, for a value out
 * of range or a degenerate shape, and {@link NullPointerException} for a missing value. Angles are degrees.
 *
 */
public sealed interface Shape permits Sphere, Rectangle, Disk, Cylinder, Cone, Cube, Box, Torus, Triangle, Mesh {

    /** The name of this kind of shape in the scene format, such as {@code "sphere"}. */
    String type();

    /** Points that give the shape's position, at least one; the shape lies within {@link #reach} of their convex hull. */
    List<ExactPoint> anchors();

    /** How far the shape reaches beyond the convex hull of its {@link #anchors}, at most: in scene units, at least 0. */
    double reach();

    /**
     * This shape after a transform.
     *
     * @throws enlightenment.math.InvalidValueException (key {@code transform}) if that makes it something that is not of this kind: a
     *     sphere that is stretched is no sphere
     */
    Shape placed(Transform transform);

    /** Whether it has an inside, which may be filled with glass or a medium; else it is a surface without thickness. */
    boolean enclosesVolume();
}
