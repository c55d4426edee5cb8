package enlightenment.geometry;

import enlightenment.check.Check;
import enlightenment.math.ExactPoint;
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
public record Cylinder(ExactPoint base, ExactPoint top, double radius, boolean capped) implements Shape {
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
    public List<ExactPoint> anchors() {
        return List.of(base, top);
    }

    @Override
    public double reach() {
        return radius;
    }
}
