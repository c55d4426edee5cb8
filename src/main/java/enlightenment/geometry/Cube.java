package enlightenment.geometry;

import enlightenment.check.Check;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import java.util.List;
import java.util.Objects;

/**
 * A cube in any orientation.
 *
 * @param center the centre
 * @param radius distance from the centre to each vertex, greater than 0
 * @param rotation degrees about x, then y, then z
 */
public record Cube(ExactPoint center, double radius, Vec3 rotation) implements Shape {
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
}
