package enlightenment.render;

import enlightenment.geometry.Box;
import enlightenment.geometry.Cone;
import enlightenment.geometry.Cube;
import enlightenment.geometry.Cylinder;
import enlightenment.geometry.Disk;
import enlightenment.geometry.Shape;
import enlightenment.geometry.Sphere;
import enlightenment.geometry.Torus;
import enlightenment.geometry.Triangle;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import java.util.LinkedHashMap;
import java.util.Map;

/** One shape of every kind, about one unit large, around the origin. */
final class Solids {
    private Solids() {}

    /** Those that enclose a volume. */
    static Map<String, Shape> solid() {
        Map<String, Shape> all = new LinkedHashMap<>();
        all.put("sphere", Sphere.of(ExactPoint.of(0.1, 0, 0.05), 1));
        all.put("box", new Box(ExactPoint.of(-0.7, -0.6, -0.5), ExactPoint.of(0.5, 0.8, 0.75)));
        all.put("upright cube", new Cube(ExactPoint.of(0.1, 0.1, 0), 1.1, new Vec3(0, 0, 0)));
        all.put("cube", new Cube(ExactPoint.of(0.1, 0.1, 0), 1.1, new Vec3(10, 35, 20)));
        all.put("cylinder", new Cylinder(ExactPoint.of(-0.3, -0.8, 0.1), ExactPoint.of(0.4, 0.7, -0.2), 0.6, true));
        all.put("upright cylinder", new Cylinder(ExactPoint.of(0, -0.8, 0), ExactPoint.of(0, 0.7, 0), 0.7, true));
        all.put("cone", new Cone(ExactPoint.of(-0.3, -0.8, 0.1), ExactPoint.of(0.4, 0.9, -0.2), 0.8, 0, true));
        all.put("frustum", new Cone(ExactPoint.of(0.2, 0.8, 0.1), ExactPoint.of(-0.1, -0.6, 0), 0.8, 0.3, true));
        all.put("torus", new Torus(ExactPoint.of(0, 0.1, 0), new Vec3(0.3, 1, -0.8), 0.8, 0.35));
        return all;
    }

    /** Those that do not. */
    static Map<String, Shape> open() {
        Map<String, Shape> all = new LinkedHashMap<>();
        all.put("rectangle", TestScenes.rectangle(-0.8, -0.7, 0.2, -0.9, 0.6, 0.1, 0.8, 0.8, -0.3, 0.9, -0.5, -0.2));
        all.put("disk", new Disk(ExactPoint.of(0.1, 0, 0), new Vec3(0.2, 0.4, -1), 0.9));
        all.put(
                "triangle",
                new Triangle(ExactPoint.of(-1, -0.8, 0), ExactPoint.of(0.1, 1, 0.4), ExactPoint.of(1, -0.6, -0.2)));
        all.put(
                "open cylinder",
                new Cylinder(ExactPoint.of(-0.3, -0.8, 0.1), ExactPoint.of(0.4, 0.7, -0.2), 0.6, false));
        all.put("open cone", new Cone(ExactPoint.of(-0.3, -0.8, 0.1), ExactPoint.of(0.4, 0.9, -0.2), 0.8, 0, false));
        return all;
    }

    static Map<String, Shape> all() {
        Map<String, Shape> all = solid();
        all.putAll(open());
        return all;
    }
}
