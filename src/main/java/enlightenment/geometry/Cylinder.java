package enlightenment.geometry;

import enlightenment.math.Check;
import enlightenment.math.Point;
import enlightenment.math.SceneFrame;
import java.util.List;
import java.util.Objects;

/**
 * A circular cylinder between two end points.
 *
 * @param base centre of the first end
 * @param top centre of the other end
 * @param radius greater than 0
 * @param capped whether the ends are closed by disks
 */
public record Cylinder(Point base, Point top, double radius, boolean capped) implements Shape {
    public Cylinder {
        Objects.requireNonNull(base, "base");
        Objects.requireNonNull(top, "top");
        Check.that(!base.equals(top), "top", "must differ from \"base\"");
        Check.positive("radius", radius);
    }

    @Override
    public String type() {
        return "cylinder";
    }

    @Override
    public Primitive place(SceneFrame frame) {
        return new CylinderPrimitive(
                frame.toFrame(base),
                frame.toFrame(top),
                Axes.between(base, top, frame),
                Sizes.inFrame(radius, frame),
                capped);
    }

    @Override
    public List<Point> anchors() {
        return List.of(base, top);
    }

    @Override
    public double reach() {
        return radius;
    }
}
