package enlightenment.geometry;

import enlightenment.check.Check;
import enlightenment.math.ExactPoint;
import java.util.List;
import java.util.Objects;

/**
 * A right circular cylinder between two points. Its faces, in order: the lateral surface, the base, the top.
 *
 * @param base centre of one end
 * @param top centre of the other end; differs from the base
 * @param radius greater than 0
 * @param capped whether disks close the ends, so that it is a solid; if not, it is the lateral surface alone
 */
public record Cylinder(ExactPoint base, ExactPoint top, double radius, boolean capped) implements Shape {
    /** Validates the components, as {@link Shape} states. */
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

    @Override
    public boolean enclosesVolume() {
        return capped;
    }

    @Override
    public Shape placed(Transform transform) {
        Similarity s = new Similarity(transform, type());
        return new Cylinder(s.point(base), s.point(top), s.length(radius), capped);
    }
}
