package enlightenment.geometry;

import enlightenment.check.Check;
import enlightenment.frame.Rotation;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import java.util.List;
import java.util.Objects;

/**
 * A solid cube in any orientation. Its faces, in order, along its own rotated axes: -x, +x, -y, +y, -z, +z.
 *
 * @param center the centre
 * @param radius distance from the centre to each vertex, greater than 0
 * @param rotation degrees about the x axis, then the y axis, then the z axis, finite; (0, 0, 0) is parallel to the axes
 */
public record Cube(ExactPoint center, double radius, Vec3 rotation) implements Shape {
    /** Validates the components, as {@link Shape} states. */
    public Cube {
        Objects.requireNonNull(center, "center");
        Objects.requireNonNull(rotation, "rotation");
        Check.positive("radius", radius);
        Check.that(rotation.isFinite(), "rotation", "must be three finite numbers");
    }

    @Override
    public String type() {
        return "cube";
    }

    @Override
    public List<ExactPoint> anchors() {
        return List.of(center);
    }

    @Override
    public double reach() {
        return radius;
    }

    @Override
    public boolean enclosesVolume() {
        return true;
    }

    @Override
    public Shape placed(Transform transform) {
        Similarity s = new Similarity(transform, type());
        return new Cube(s.point(center), s.length(radius), s.angles(Rotation.ofDegrees(rotation)));
    }
}
