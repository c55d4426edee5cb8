package enlightenment.importer.support;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.color.Rgb;
import enlightenment.geometry.Box;
import enlightenment.geometry.Cylinder;
import enlightenment.geometry.Disk;
import enlightenment.geometry.Mesh;
import enlightenment.geometry.Rectangle;
import enlightenment.geometry.Shape;
import enlightenment.geometry.Sphere;
import enlightenment.light.Light;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.mesh.TriangleMesh;
import java.util.List;
import org.junit.jupiter.api.Test;

class PlacedShapesTest {
    private static final Affine TURNED = Affine.translate(1, 2, 3)
            .after(Affine.rotate(new Vec3(1, 2, 3), 40))
            .after(Affine.scale(2, 2, 2));

    private static final Affine STRETCHED = Affine.rotate(new Vec3(3, 1, 2), 70).after(Affine.scale(1, 2, 3));

    private final ImportNotes notes = new ImportNotes();
    private final PlacedShapes shapes = new PlacedShapes(notes, false);

    @Test
    void rectanglesStayParallelogramsUnderEveryMap() {
        Affine skew = new Affine(new Vec3(1, 0.5, 0), new Vec3(0, 1, 0), new Vec3(0.1, 0, 0), new Vec3(0.1, 0.2, 0.3));
        Rectangle r = shapes.rectangle(skew);
        assertEquals(ExactPoint.of("-1.4", "-0.8", "0.2"), r.lowerLeft());
        assertEquals(ExactPoint.of("1.6", "1.2", "0.4"), r.upperRight());
        assertEquals(List.of(), notes.list());
    }

    @Test
    void spheresStaySpheresUnderSimilarities() {
        Sphere s = (Sphere) shapes.sphere(TURNED, false, "");
        assertEquals(2, s.radius(), 1e-12);
        assertEquals(ExactPoint.of(1, 2, 3), s.center());
        assertInstanceOf(Sphere.class, shapes.sphere(Affine.scale(-2, 2, 2), false, ""));
    }

    @Test
    void matricesOfSixDigitsCountAsSimilarities() {
        Affine printed = new Affine(
                new Vec3(0.866025, -0.5, 0), new Vec3(0.5, 0.866025, 0), new Vec3(0, 0, 1), new Vec3(0, 0, 0));
        assertInstanceOf(Sphere.class, shapes.sphere(printed, false, ""));
    }

    @Test
    void stretchedSpheresAreMeshesOfTheVolumeOfTheirEllipsoid() {
        Mesh mesh = (Mesh) shapes.sphere(STRETCHED, false, "line 7");
        assertTrue(mesh.enclosesVolume());
        double volume = mesh.triangles().volume() * StrictMath.abs(STRETCHED.determinant());
        // A sphere of n triangles around misses a share of about 1 / n² times a small number.
        assertEquals(8 * StrictMath.PI, volume, 8 * StrictMath.PI * 0.003);
        assertEquals(List.of("line 7: a stretched sphere becomes triangles"), notes.list());
    }

    @Test
    void disksStayDisksWhereTheirPlaneIsNotStretched() {
        Disk d = (Disk) shapes.disk(Affine.scale(2, 2, 5), false, "");
        assertEquals(2, d.radius(), 1e-12);
        assertEquals(1, d.normal().normalized().z(), 1e-12);
        Mesh ellipse = (Mesh) shapes.disk(Affine.scale(2, 1, 1), false, "");
        assertEquals(2 * StrictMath.PI, 2 * area(ellipse.triangles()), 0.01);
    }

    @Test
    void cylindersStayCylindersHoweverLongTheyBecome() {
        Cylinder c = (Cylinder) shapes.cylinder(TURNED.after(Affine.scale(1, 1, 10)), false, "");
        assertEquals(2, c.radius(), 1e-12);
        assertEquals(20, c.top().minus(c.base()).length(), 1e-12);
        assertInstanceOf(Mesh.class, shapes.cylinder(STRETCHED, false, ""));
    }

    @Test
    void cubesAreBoxesParallelogramsOrMeshes() {
        Affine quarter = Affine.translate(1, 0, 0).after(Affine.scale(1, 2, 3));
        Box box = (Box) PlacedShapes.cube(quarter, false, false).get(0);
        assertEquals(ExactPoint.of(0, -2, -3), box.min());
        assertEquals(ExactPoint.of(2, 2, 3), box.max());
        List<Shape> faces = PlacedShapes.cube(STRETCHED, false, false);
        assertEquals(6, faces.size());
        double sum = 0;
        for (Shape face : faces) {
            Rectangle r = (Rectangle) face;
            Vec3 n = r.upperLeft().minus(r.lowerLeft()).cross(r.lowerRight().minus(r.lowerLeft()));
            sum += StrictMath.abs(n.dot(r.lowerLeft().toVec3())) / 3;
        }
        // The pyramids from the middle to the faces fill the cube.
        assertEquals(8 * 6, sum, 1e-9);
        Mesh solid = (Mesh) PlacedShapes.cube(STRETCHED, false, true).get(0);
        assertTrue(solid.enclosesVolume());
        assertEquals(8, solid.triangles().volume(), 1e-12);
    }

    @Test
    void facesOfACubeLookOutwardsAndShareTheirCornersExactly() {
        java.util.Set<ExactPoint> corners = new java.util.HashSet<>();
        for (Shape face : PlacedShapes.cube(STRETCHED, false, false)) {
            Rectangle r = (Rectangle) face;
            corners.addAll(r.anchors());
        }
        assertTrue(corners.size() >= 8);
        java.util.Set<ExactPoint> exact = new java.util.HashSet<>();
        for (Shape face :
                PlacedShapes.cube(Affine.rotate(Vec3.Z, 90).after(Affine.scale(0.1, 0.7, 0.3)), true, false)) {
            exact.addAll(face.anchors());
        }
        assertEquals(8, exact.size());
    }

    @Test
    void oneSidedLampsShineToTheirFront() {
        for (int side = -1; side <= 1; side += 2) {
            Vec3 front = TURNED.vector(new Vec3(0, 0, side));
            Light.Rectangle lamp = PlacedShapes.oneSided(shapes.rectangle(TURNED), front, Rgb.WHITE);
            assertTrue(ExactPoint.normal(lamp.lowerLeft(), lamp.upperLeft(), lamp.lowerRight())
                            .dot(front)
                    > 0);
        }
    }

    private static double area(TriangleMesh mesh) {
        double sum = 0;
        for (int t = 0; t < mesh.triangles(); t++) {
            sum += mesh.areaNormal(t).length() / 2;
        }
        return sum;
    }
}
