package enlightenment.geometry;

import enlightenment.check.Check;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import java.util.List;
import java.util.Objects;

/**
 * A ring of circular section.
 *
 * @param center the centre
 * @param axis direction that the ring lies around, of any length
 * @param majorRadius from the centre to the middle of the section
 * @param minorRadius radius of the section, greater than 0 and at most the major radius
 */
public record Torus(ExactPoint center, Vec3 axis, double majorRadius, double minorRadius) implements Shape {
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
}
