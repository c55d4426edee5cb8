package enlightenment.geometry;

import enlightenment.math.Check;
import enlightenment.math.Point;
import enlightenment.math.SceneFrame;
import enlightenment.math.Vec3;
import java.util.List;

/**
 * A cube in any orientation.
 *
 * @param center the centre
 * @param radius distance from the centre to each vertex, greater than 0
 * @param rotation degrees about x, then y, then z
 */
public record Cube(Point center, double radius, Vec3 rotation) implements Shape {
    public Cube {
        Check.positive("radius", radius);
        Check.that(rotation.isFinite(), "rotation", "must be three finite numbers");
    }

    @Override
    public String type() {
        return "cube";
    }

    @Override
    public Primitive place(SceneFrame frame) {
        throw new UnsupportedOperationException("not placed yet");
    }

    @Override
    public List<Point> anchors() {
        return List.of(center);
    }

    @Override
    public double reach() {
        return radius;
    }
}
