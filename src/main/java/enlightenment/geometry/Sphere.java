package enlightenment.geometry;

import enlightenment.check.Check;
import enlightenment.math.ExactPoint;
import java.util.List;
import java.util.Objects;

/**
 * A ball: all points within a radius of its centre.
 *
 * @param center the centre
 * @param radius greater than 0
 * @param rotation turns the texture about +y by this angle in degrees, finite; at 0 the texture's left edge faces -z
 *
 */
public record Sphere(ExactPoint center, double radius, double rotation) implements Shape {
    /** Validates the components, as {@link Shape} states. */
    public Sphere {
        Objects.requireNonNull(center, "center");
        Check.positive("radius", radius);
        Check.finite("rotation", rotation);
    }

    /** The ball of this centre and radius, its texture not rotated. */
    public static Sphere of(ExactPoint center, double radius) {
        return new Sphere(center, radius, 0);
    }

    @Override
    public String type() {
        return "sphere";
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
        return true;
    }

    @Override
    public Shape placed(Transform transform) {
        Similarity s = new Similarity(transform, type());
        return new Sphere(s.point(center), s.length(radius), rotation);
    }
}
