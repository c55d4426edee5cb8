package enlightenment.geometry;

import enlightenment.math.Check;
import enlightenment.math.Point;
import enlightenment.math.SceneFrame;
import enlightenment.math.Vec3;
import java.util.List;
import java.util.Objects;

/**
 * A flat disk, seen from both sides.
 *
 * @param center the centre
 * @param normal direction perpendicular to it, of any length
 * @param radius greater than 0
 */
public record Disk(Point center, Vec3 normal, double radius) implements Shape {
    public Disk {
        Objects.requireNonNull(center, "center");
        Objects.requireNonNull(normal, "normal");
        Check.direction("normal", normal);
        Check.positive("radius", radius);
    }

    @Override
    public String type() {
        return "disk";
    }

    @Override
    public Primitive place(SceneFrame frame) {
        return new DiskPrimitive(frame.toFrame(center), normal, Sizes.inFrame(radius, frame));
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
