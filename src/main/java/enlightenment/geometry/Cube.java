package enlightenment.geometry;

import enlightenment.math.Check;
import enlightenment.math.Point;
import enlightenment.math.Rotation;
import enlightenment.math.SceneFrame;
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
public record Cube(Point center, double radius, Vec3 rotation) implements Shape {
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
    public Primitive place(SceneFrame frame) {
        Vec3 middle = frame.toFrame(center);
        // The diagonal of a cube is sqrt(3) times its edge.
        double half = Sizes.inFrame(radius, frame) / Math.sqrt(3);
        Rotation turn = Rotation.ofDegrees(rotation);
        return CubePrimitive.isUpright(turn) ? CubePrimitive.box(middle, half) : new CubePrimitive(middle, half, turn);
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
