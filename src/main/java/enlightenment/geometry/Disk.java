package enlightenment.geometry;

import enlightenment.check.Check;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import java.util.List;
import java.util.Objects;

/**
 * A flat disk, visible from both sides.
 *
 * @param center the centre
 * @param normal a direction perpendicular to it, finite, of any length but 0
 * @param radius greater than 0
 */
public record Disk(ExactPoint center, Vec3 normal, double radius) implements Shape {
    /** Validates the components, as {@link Shape} states. */
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
    public List<ExactPoint> anchors() {
        return List.of(center);
    }

    @Override
    public double reach() {
        return radius;
    }

    @Override
    public boolean enclosesVolume() {
        return false;
    }

    @Override
    public Shape placed(Transform transform) {
        Similarity s = new Similarity(transform, type());
        return new Disk(s.point(center), s.direction(normal), s.length(radius));
    }
}
