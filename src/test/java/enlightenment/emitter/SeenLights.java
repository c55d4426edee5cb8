package enlightenment.emitter;

import enlightenment.geometry.Box;
import enlightenment.geometry.Cone;
import enlightenment.geometry.Cube;
import enlightenment.geometry.Cylinder;
import enlightenment.geometry.Disk;
import enlightenment.geometry.Rectangle;
import enlightenment.geometry.Shape;
import enlightenment.geometry.Sphere;
import enlightenment.geometry.Torus;
import enlightenment.geometry.Triangle;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;

/** Lights of every form from everywhere that matters: near, far, at grazing angles, inside. */
final class SeenLights {
    private static final Shape RECTANGLE = parallelogram(2, 0, 0, 1);
    private static final Shape PARALLELOGRAM = parallelogram(2, 0.3, 0.5, 1.5);

    private SeenLights() {}

    /** A parallelogram in the plane z = 0 with one corner in the origin, and the edges right and up. */
    static Shape parallelogram(double rx, double ry, double ux, double uy) {
        return new Rectangle(
                ExactPoint.ORIGIN,
                ExactPoint.of(ux, uy, 0),
                ExactPoint.of(rx + ux, ry + uy, 0),
                ExactPoint.of(rx, ry, 0));
    }

    static List<SeenLight> all() {
        List<SeenLight> all = new ArrayList<>();
        Sphere ball = Sphere.of(ExactPoint.of(1, 2, -1), 0.8);
        add(all, "ball", ball, 0, LightSides.FRONT, new Vec3(0, 0, 0), new Vec3(1, 2, -0.199), new Vec3(1e7, 3e7, 1e7));
        // Up × right of these is -z: the front is seen from there.
        add(
                all,
                "rectangle",
                RECTANGLE,
                0,
                LightSides.FRONT,
                new Vec3(0.5, 0.2, -1),
                new Vec3(3, 4, -2),
                new Vec3(1, 0.5, -1e-3));
        add(all, "far rectangle", RECTANGLE, 0, LightSides.FRONT, new Vec3(300, 400, -200), new Vec3(9, 9, -1e6));
        add(all, "two-sided rectangle", RECTANGLE, 0, LightSides.BOTH, new Vec3(0.5, 0.2, 1), new Vec3(3, -2, -0.5));
        add(all, "parallelogram", PARALLELOGRAM, 0, LightSides.FRONT, new Vec3(0.5, 0.2, -1), new Vec3(5, 4, -3));
        add(
                all,
                "two-sided parallelogram",
                PARALLELOGRAM,
                0,
                LightSides.BOTH,
                new Vec3(1, 0.5, 0.5),
                new Vec3(50, 90, 70));
        Triangle triangle = new Triangle(ExactPoint.ORIGIN, ExactPoint.of(0, 2, 1), ExactPoint.of(2, 0.5, 0));
        add(
                all,
                "triangle",
                triangle,
                0,
                LightSides.BOTH,
                new Vec3(0.5, 0.5, 2),
                new Vec3(1, 1, -1),
                new Vec3(70, -20, 40));
        Disk disk = new Disk(ExactPoint.of(1, 1, 1), new Vec3(0, 0, 1), 0.7);
        add(all, "disk", disk, 0, LightSides.FRONT, new Vec3(0, 0, 2), new Vec3(1.2, 1, 3));
        add(all, "two-sided disk", disk, 0, LightSides.BOTH, new Vec3(0, 0, -2), new Vec3(30, 50, 20));
        Cylinder pipe = new Cylinder(ExactPoint.ORIGIN, ExactPoint.of(1, 2, 0.5), 0.6, false);
        add(all, "open cylinder", pipe, 0, LightSides.BOTH, new Vec3(3, 0, 1), new Vec3(-1, -2, -0.4));
        Cylinder rod = new Cylinder(ExactPoint.ORIGIN, ExactPoint.of(1, 2, 0.5), 0.6, true);
        add(all, "cylinder's side", rod, 0, LightSides.BOTH, new Vec3(3, 0, 1), new Vec3(40, 70, 90));
        add(all, "cylinder's base", rod, 1, LightSides.BOTH, new Vec3(-2, -1, -1));
        add(all, "cylinder's top", rod, 2, LightSides.BOTH, new Vec3(2, 4, 1));
        Cone cone = new Cone(ExactPoint.ORIGIN, ExactPoint.of(0, 1, 0), 1, 0, true);
        add(all, "cone's side", cone, 0, LightSides.FRONT, new Vec3(1, 2, 0.5), new Vec3(2, 0.5, 0));
        Cone frustum = new Cone(ExactPoint.ORIGIN, ExactPoint.of(0, 1, 0), 0.3, 0.8, true);
        add(all, "frustum's side", frustum, 0, LightSides.FRONT, new Vec3(1, -2, 0.5), new Vec3(2, 0.5, 0));
        Torus torus = new Torus(ExactPoint.of(0, 0, 0), new Vec3(1, 2, 0), 1, 0.4);
        add(all, "torus", torus, 0, LightSides.FRONT, new Vec3(2, 1, 2), new Vec3(0, 0.5, 4));
        Torus horn = new Torus(ExactPoint.of(0, 0, 0), new Vec3(0, 0, 1), 1, 1);
        add(all, "horn torus", horn, 0, LightSides.FRONT, new Vec3(2, 1, 2));
        Box box = new Box(ExactPoint.of(0, 0, 0), ExactPoint.of(1, 2, 3));
        Cube cube = new Cube(ExactPoint.of(0, 0, 0), 1, new Vec3(20, 30, 40));
        for (int face = 0; face < 6; face++) {
            double s = face % 2 == 1 ? 1 : -1;
            Vec3 axis = face / 2 == 0 ? Vec3.X : face / 2 == 1 ? Vec3.Y : Vec3.Z;
            add(
                    all,
                    "box's face " + face,
                    box,
                    face,
                    LightSides.FRONT,
                    new Vec3(0.3, 0.6, 1.1).plus(axis.times(4 * s)));
        }
        add(all, "cube's face", cube, 0, LightSides.FRONT, new Vec3(-3, -0.5, 0.5));
        addInner(all);
        return all;
    }

    /** Lights that shine to their backs, from there. */
    private static void addInner(List<SeenLight> all) {
        LightSides back = LightSides.BACK;
        Sphere ball = Sphere.of(ExactPoint.of(1, 2, -1), 0.8);
        add(all, "inside of a ball", ball, 0, back, new Vec3(1.1, 2, -1), new Vec3(1.5, 2.3, -1.2), new Vec3(4, 2, 1));
        add(all, "back of a rectangle", RECTANGLE, 0, back, new Vec3(0.5, 0.2, 1), new Vec3(3, -2, 0.5));
        add(all, "back of a parallelogram", PARALLELOGRAM, 0, back, new Vec3(1, 0.5, 0.5));
        Triangle triangle = new Triangle(ExactPoint.ORIGIN, ExactPoint.of(0, 2, 1), ExactPoint.of(2, 0.5, 0));
        add(all, "back of a triangle", triangle, 0, back, new Vec3(0.5, 0.5, 2), new Vec3(2, 1, 3));
        Disk disk = new Disk(ExactPoint.of(1, 1, 1), new Vec3(0, 0, 1), 0.7);
        add(all, "back of a disk", disk, 0, back, new Vec3(0, 0, -2));
        Cylinder rod = new Cylinder(ExactPoint.ORIGIN, ExactPoint.of(1, 2, 0.5), 0.6, true);
        add(all, "inside of a cylinder's side", rod, 0, back, new Vec3(0.5, 1, 0.2));
        add(all, "inside of a cylinder's base", rod, 1, back, new Vec3(0.5, 1, 0.2));
        add(all, "inside of a cylinder's top", rod, 2, back, new Vec3(0.5, 1, 0.2));
        Torus torus = new Torus(ExactPoint.of(0, 0, 0), new Vec3(1, 2, 0), 1, 0.4);
        add(all, "inside of a torus", torus, 0, back, new Vec3(0.1, -0.1, 0.9), new Vec3(2, 1, 2));
        Box box = new Box(ExactPoint.of(0, 0, 0), ExactPoint.of(1, 2, 3));
        Cube cube = new Cube(ExactPoint.of(0, 0, 0), 1, new Vec3(20, 30, 40));
        for (int face = 0; face < 6; face++) {
            add(all, "inside of a box's face " + face, box, face, back, new Vec3(0.3, 0.6, 1.1));
            add(all, "inside of a cube's face " + face, cube, face, back, new Vec3(0.1, 0.2, -0.1));
        }
    }

    /** One view of each form. */
    static List<SeenLight> forms() {
        List<SeenLight> forms = new ArrayList<>();
        Set<String> names = new HashSet<>();
        for (SeenLight seen : all()) {
            if (names.add(seen.name.substring(0, seen.name.indexOf(" from")))) {
                forms.add(seen);
            }
        }
        return forms;
    }

    private static void add(
            List<SeenLight> all, String name, Shape shape, int face, LightSides sides, Vec3... viewers) {
        for (Vec3 v : viewers) {
            all.add(new SeenLight(name + " from " + v, shape, face, sides, v));
        }
    }
}
