package enlightenment.geometry;

import enlightenment.check.Check;
import enlightenment.math.ExactPoint;
import java.util.List;
import java.util.Objects;

/**
 * A right circular cone, or a frustum of one where the top radius is not 0. Its faces, in order: the lateral surface, the base,
 * the top.
 *
 * @param base centre of the base
 * @param apex centre of the other end, the cone's apex where {@code topRadius} is 0; differs from the base
 * @param radius radius at the base, greater than 0
 * @param topRadius radius at the apex, at least 0
 * @param capped whether disks close the ends, so that it is a solid; if not, it is the lateral surface alone
 */
public record Cone(ExactPoint base, ExactPoint apex, double radius, double topRadius, boolean capped) implements Shape {
    /** Validates the components, as {@link Shape} states. */
    public Cone {
        Objects.requireNonNull(base, "base");
        Objects.requireNonNull(apex, "apex");
        Check.that(!base.equals(apex), "apex", "must differ from \"base\"");
        Check.positive("radius", radius);
        Check.notNegative("topRadius", topRadius);
    }

    @Override
    public String type() {
        return "cone";
    }

    @Override
    public List<ExactPoint> anchors() {
        return List.of(base, apex);
    }

    @Override
    public double reach() {
        return Math.max(radius, topRadius);
    }

    @Override
    public boolean enclosesVolume() {
        return capped;
    }

    @Override
    public Shape placed(Transform transform) {
        Similarity s = new Similarity(transform, type());
        return new Cone(s.point(base), s.point(apex), s.length(radius), s.length(topRadius), capped);
    }
}
