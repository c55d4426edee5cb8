package enlightenment.geometry;

import enlightenment.check.Check;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import java.util.List;
import java.util.Objects;

/**
 * A solid torus: all points within {@code minorRadius} of a circle.
 *
 * @param center the centre of the circle
 * @param axis the axis of rotation, perpendicular to the circle: finite, of any length but 0
 * @param majorRadius radius of the circle, greater than 0
 * @param minorRadius radius of the tube, greater than 0 and at most the major radius
 */
public record Torus(ExactPoint center, Vec3 axis, double majorRadius, double minorRadius) implements Shape {
    /** Validates the components, as {@link Shape} states. */
    public Torus {
        Objects.requireNonNull(center, "center");
        Objects.requireNonNull(axis, "axis");
        Check.direction("axis", axis);
        Check.positive("majorRadius", majorRadius);
        Check.positive("minorRadius", minorRadius);
        Check.that(
                minorRadius <= majorRadius,
                "minorRadius",
                "must be at most \"majorRadius\", which is " + majorRadius + ", not " + minorRadius);
    }

    @Override
    public String type() {
        return "torus";
    }

    @Override
    public List<ExactPoint> anchors() {
        return List.of(center);
    }

    @Override
    public double reach() {
        return majorRadius + minorRadius;
    }

    @Override
    public boolean enclosesVolume() {
        return true;
    }

    @Override
    public Shape placed(Transform transform) {
        Similarity s = new Similarity(transform, type());
        return new Torus(s.point(center), s.direction(axis), s.length(majorRadius), s.length(minorRadius));
    }
}
