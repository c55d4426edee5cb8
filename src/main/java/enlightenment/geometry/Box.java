package enlightenment.geometry;

import enlightenment.check.Check;
import enlightenment.math.ExactPoint;
import java.util.List;
import java.util.Objects;

/**
 * A solid box parallel to the coordinate axes. Its faces, in order: -x, +x, -y, +y, -z, +z.
 *
 * @param min lower corner
 * @param max upper corner, greater than {@code min} in every coordinate
 */
public record Box(ExactPoint min, ExactPoint max) implements Shape {
    /** Validates the components, as {@link Shape} states. */
    public Box {
        Objects.requireNonNull(min, "min");
        Objects.requireNonNull(max, "max");
        for (int k = 0; k < 3; k++) {
            Check.that(
                    min.component(k).compareTo(max.component(k)) < 0,
                    "max/" + k,
                    "must be greater than the same coordinate of \"min\"");
        }
    }

    @Override
    public String type() {
        return "box";
    }

    @Override
    public List<ExactPoint> anchors() {
        return List.of(min, max);
    }

    @Override
    public double reach() {
        return 0;
    }

    @Override
    public boolean enclosesVolume() {
        return true;
    }

    @Override
    public Shape placed(Transform transform) {
        ExactPoint p = transform.apply(min);
        ExactPoint q = transform.apply(max);
        Check.that(
                transform.keepsAxes(),
                "transform",
                "turns a box, which can be moved, scaled, and turned by quarters of a turn; a cube, or a mesh, can be turned");
        return new Box(
                new ExactPoint(p.x().min(q.x()), p.y().min(q.y()), p.z().min(q.z())),
                new ExactPoint(p.x().max(q.x()), p.y().max(q.y()), p.z().max(q.z())));
    }
}
