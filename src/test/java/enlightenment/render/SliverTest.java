package enlightenment.render;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.camera.Camera;
import enlightenment.color.DisplayRgb;
import enlightenment.geometry.Cone;
import enlightenment.geometry.Cylinder;
import enlightenment.geometry.Disk;
import enlightenment.geometry.Rectangle;
import enlightenment.geometry.Shape;
import enlightenment.geometry.Triangle;
import enlightenment.light.Light;
import enlightenment.math.ExactPoint;
import enlightenment.math.InvalidValueException;
import enlightenment.math.Vec3;
import enlightenment.scene.Scene;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** What is thinner than doubles can tell is a shape all the same; what has no width as exact decimals is none. */
class SliverTest {
    private static ExactPoint p(String x, String y, String z) {
        return ExactPoint.of(x, y, z);
    }

    @ParameterizedTest
    @ValueSource(strings = {"1e-15", "1e-17", "1e-40", "1e-300", "1e-900"})
    void onlyPointsInOneLineAreNoTriangle(String width) {
        new Triangle(p("0", "0", "0"), p("1", "0", "0"), p("0.5", width, "0"));
        new Triangle(p("0.1", "0.2", "0.3"), p("0.2", "0.4", "0.6"), p("0.3", "0.6", "0.9" + "0".repeat(900) + "1"));
        new Rectangle(
                p("1", "2", "3"),
                p("1", "2", "4"),
                p("1", "2" + "." + "0".repeat(30) + "1", "4"),
                p("1", "2." + "0".repeat(30) + "1", "3"));
        // A tenth, two and three tenths are in one line, although their doubles are not.
        assertThrows(
                InvalidValueException.class,
                () -> new Triangle(p("0.1", "0.7", "0"), p("0.2", "1.4", "0"), p("0.3", "2.1", "0")));
        assertThrows(
                InvalidValueException.class,
                () -> new Triangle(p("0", "0", "0"), p(width, width, "0"), p("1e300", "1e300", "0")));
        assertThrows(
                InvalidValueException.class,
                () -> new Triangle(p("0", "0", width), p("0", "0", width), p("1", "2", "3")));
    }

    private static Scene.Builder room(Camera camera) {
        return Scene.builder().size(16, 16).camera(camera).light(new Light.Point(p("2", "3", "-4"), DisplayRgb.WHITE));
    }

    private static DoublePicture picture(Scene.Builder scene) {
        return DoublePicture.of(scene.build(), 2, 1);
    }

    /** Seen through a window four times as high as the sliver is wide, it covers a quarter of the rows. */
    @ParameterizedTest
    @ValueSource(ints = {-10, -20, -100})
    void aSliverIsAsWideAsItIs(int e) {
        String half = "0.5e" + e;
        String width = "1e" + e;
        Camera near = new Camera.Orthographic(
                p("0.5", half, "-" + width), p("0.5", half, "0"), Vec3.Y, Double.parseDouble("4e" + e));
        DisplayRgb white = DisplayRgb.WHITE;
        Shape triangle = new Triangle(p("-1e9", "0", "0"), p("1e9", "0", "0"), p("0.5", width, "0"));
        Shape rectangle = new Rectangle(p("-1", "0", "0"), p("2", "0", "0"), p("2", width, "0"), p("-1", width, "0"));
        for (Shape shape : new Shape[] {triangle, rectangle}) {
            Scene scene = Scene.builder()
                    .size(16, 16)
                    .camera(near)
                    .object(shape, TestScenes.matte(1, 1, 1))
                    .build();
            DoublePicture p = DoublePicture.of(scene, 1, 1);
            for (int y = 0; y < 16; y++) {
                boolean covered = y >= 6 && y < 10;
                assertEquals(covered, p.at(8, y, 0) > 0, shape.type() + " 1e" + e + ", row " + y + " of " + white);
            }
        }
    }

    /** A wall with a sliver in it, which rounding puts into one line, looks like a wall. */
    @ParameterizedTest
    @ValueSource(strings = {"1e-15", "1e-17", "1e-30", "1e-400"})
    void aSliverLeavesNoHoleInAWall(String width) {
        Camera camera = new Camera.Perspective(p("0.37", "0.21", "-2.9"), p("0.51", "0.03", "0.4"), Vec3.Y, 20);
        ExactPoint left = p("-1", "-0.3", "0.1");
        ExactPoint right = p("2", "0.9", "0.7");
        // Near the middle of the two.
        ExactPoint middle = ExactPoint.of("0.5", "0.3", "0.4");
        middle = new ExactPoint(middle.x(), middle.y().add(new java.math.BigDecimal(width)), middle.z());
        ExactPoint below = p("0.5", "-5", "0.4");
        ExactPoint above = p("0.5", "5", "0.4");
        Scene.Builder pieces = room(camera);
        Scene.Builder whole = room(camera);
        for (Shape s : new Shape[] {
            new Triangle(left, right, middle),
            new Triangle(left, below, right),
            new Triangle(left, middle, above),
            new Triangle(middle, right, above)
        }) {
            pieces.object(s, TestScenes.matte(1, 1, 1));
        }
        whole.object(new Triangle(left, below, above), TestScenes.matte(1, 1, 1));
        whole.object(new Triangle(right, below, above), TestScenes.matte(1, 1, 1));
        assertTrue(picture(whole).least() > 0);
        assertEquals(0, picture(pieces).difference(picture(whole)), 1e-9);
    }

    /** Thinner than any double near it, a closed solid is a disk, whatever the direction of its axis. */
    @ParameterizedTest
    @ValueSource(ints = {-15, -16, -17, -40, -250, -300, -350})
    void aWaferIsADisk(int e) {
        Camera camera = new Camera.Perspective(p("0.3", "0.4", "-3"), p("0.7", "0.1", "1"), Vec3.Y, 40);
        ExactPoint base = p("0.7", "0.1", "1.3");
        ExactPoint top = new ExactPoint(
                base.x().add(new java.math.BigDecimal("1e" + e)),
                base.y().subtract(new java.math.BigDecimal("2e" + e)),
                base.z().subtract(new java.math.BigDecimal("2e" + e)));
        DoublePicture disk =
                picture(room(camera).object(new Disk(base, new Vec3(1, -2, -2), 0.9), TestScenes.matte(1, 1, 1)));
        assertTrue(disk.least() == 0 && disk.greatest() > 0.5);
        for (Shape s : new Shape[] {new Cylinder(base, top, 0.9, true), new Cone(base, top, 0.9, 0.9, true)}) {
            DoublePicture wafer = picture(room(camera).object(s, TestScenes.matte(1, 1, 1)));
            assertEquals(0, wafer.difference(disk), 1e-9, s.type());
        }
    }
}
