package enlightenment.geometry;

import enlightenment.math.Check;
import enlightenment.math.Point;
import enlightenment.math.Rotation;
import enlightenment.math.SceneFrame;
import enlightenment.math.Vec3;
import java.util.List;
import java.util.Objects;

/**
 * A ball's surface.
 *
 * @param center the centre
 * @param radius greater than 0
 * @param rotation turns the texture about +y by this many degrees; at 0 the texture's left edge faces -z
 */
public record Sphere(Point center, double radius, double rotation) implements Shape {
    public Sphere {
        Objects.requireNonNull(center, "center");
        Check.positive("radius", radius);
        Check.finite("rotation", rotation);
    }

    public static Sphere of(Point center, double radius) {
        return new Sphere(center, radius, 0);
    }

    @Override
    public String type() {
        return "sphere";
    }

    @Override
    public Primitive place(SceneFrame frame) {
        Vec3 meridian = Rotation.aboutY(rotation).apply(new Vec3(0, 0, -1));
        return new SpherePrimitive(frame.toFrame(center), Sizes.inFrame(radius, frame), meridian.x(), meridian.z());
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
