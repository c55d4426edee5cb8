package enlightenment.primitive;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.frame.Rotation;
import enlightenment.frame.SceneFrame;
import enlightenment.geometry.Cube;
import enlightenment.geometry.Triangle;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import org.junit.jupiter.api.Test;

/** u runs to the right and v downwards for a viewer outside; (0, 0) is the upper left corner. */
class FlatTextureTest {
    private static final double TOLERANCE = 1e-12;

    /** Looks at the point from the side of the normal and checks the texture coordinates there. */
    private static void assertTexture(Primitive p, Vec3 at, Vec3 normal, double u, double v) {
        Hit hit = new Hit();
        assertTrue(p.intersect(Ray.of(at.plus(normal), normal.negated()), hit), "met at " + at);
        assertEquals(Ray.OUTSIDE, hit.side);
        p.textureCoordinates(hit);
        assertEquals(u, hit.u, TOLERANCE, "u at " + at);
        assertEquals(v, hit.v, TOLERANCE, "v at " + at);
    }

    @Test
    void theCornersOfARectangleAreTheCornersOfItsTexture() {
        // Seen by the paper's viewer, who looks along +z with +x to the right.
        Vec3 a = new Vec3(0, 0, 5);
        Vec3 b = new Vec3(0, 2, 5);
        Vec3 c = new Vec3(4, 2, 5);
        Vec3 d = new Vec3(4, 0, 5);
        Primitive p = new RectanglePrimitive(a, b, c, d);
        Vec3 viewer = new Vec3(0, 0, -1);
        assertTexture(p, b, viewer, 0, 0);
        assertTexture(p, c, viewer, 1, 0);
        assertTexture(p, a, viewer, 0, 1);
        assertTexture(p, d, viewer, 1, 1);
        assertTexture(p, new Vec3(1, 1.5, 5), viewer, 0.25, 0.25);
    }

    @Test
    void aTriangleCarriesTheLowerLeftHalfOfItsTexture() {
        Vec3 a = new Vec3(1, 1, 3);
        Vec3 b = new Vec3(1, 3, 3);
        Vec3 c = new Vec3(5, 1, 3);
        Primitive p = new TrianglePrimitive(a, b, c);
        Vec3 viewer = new Vec3(0, 0, -1);
        assertTexture(p, a, viewer, 0, 1);
        assertTexture(p, b, viewer, 0, 0);
        assertTexture(p, c, viewer, 1, 1);
        assertTexture(p, new Vec3(2, 1.5, 3), viewer, 0.25, 0.75);
    }

    @Test
    void aBoxShowsItsTextureUprightOnEverySide() {
        assertUprightFaces(new BoxPrimitive(new Vec3(-1, -1, -1), new Vec3(1, 1, 1)), Rotation.IDENTITY);
    }

    @Test
    void aCubeTurnsWithItsTextures() {
        for (int i = 0; i < 64; i++) {
            Rotation r = Rotation.ofDegrees(new Vec3(90 * (i & 3), 90 * (i >> 2 & 3), 90 * (i >> 4 & 3)));
            assertUprightFaces(new CubePrimitive(Vec3.ZERO, 1, r), r);
        }
        RandomRays random = new RandomRays(7);
        for (int i = 0; i < 50; i++) {
            Rotation r = random.rotation();
            assertUprightFaces(new CubePrimitive(Vec3.ZERO, 1, r), r);
        }
    }

    /** Checks all corners of all faces, a hair inside, so that each is met on its own face. */
    private static void assertUprightFaces(Primitive p, Rotation turn) {
        Vec3 y = Vec3.Y;
        Vec3[][] outwardAndUp = {
            {Vec3.X.negated(), y},
            {Vec3.X, y},
            // Top and bottom continue the face -z: their edges towards -z join it.
            {y.negated(), Vec3.Z.negated()},
            {y, Vec3.Z},
            {Vec3.Z.negated(), y},
            {Vec3.Z, y}
        };
        for (Vec3[] face : outwardAndUp) {
            Vec3 n = face[0];
            Vec3 up = face[1];
            // With x to the right, y up and z away from the viewer, "right" is up × ahead, and ahead is −n.
            Vec3 right = up.cross(n.negated());
            for (int corner = 0; corner < 4; corner++) {
                double s = (corner & 1) == 0 ? -1 : 1;
                double t = (corner & 2) == 0 ? -1 : 1;
                double hair = 1 - 1e-13;
                Vec3 at = n.plus(right.times(s * hair)).plus(up.times(t * hair));
                assertTexture(p, turn.apply(at), turn.apply(n), (1 + s) / 2, (1 - t) / 2);
            }
        }
    }

    @Test
    void shapesArePlacedInTheirFrame() {
        SceneFrame frame = new SceneFrame(ExactPoint.of(10, 20, 30), 1);
        Primitive box = Primitives.place(
                new enlightenment.geometry.Box(ExactPoint.of(10, 20, 30), ExactPoint.of(12, 24, 36)), frame);
        assertEquals(new Vec3(1, 2, 3), box.bounds().max());
        Primitive upright = Primitives.place(new Cube(ExactPoint.of(10, 20, 34), 2 * Math.sqrt(3), Vec3.ZERO), frame);
        assertEquals(new Vec3(1, 1, 3), upright.bounds().max());
        assertTrue(upright instanceof BoxPrimitive);
        Primitive almost = Primitives.place(new Cube(ExactPoint.ORIGIN, 1, new Vec3(1e-9, 0, 0)), frame);
        assertTrue(almost instanceof CubePrimitive, "a turn by a billionth of a degree is a turn");
        Primitive turned = Primitives.place(new Cube(ExactPoint.of(10, 20, 30), 2, new Vec3(0, 0, 45)), frame);
        assertEquals(2 / Math.sqrt(6), turned.bounds().max().x(), 1e-15, "half a face's diagonal");
        Primitive triangle = Primitives.place(
                new Triangle(ExactPoint.of(10, 20, 30), ExactPoint.of(10, 22, 30), ExactPoint.of(14, 20, 30)), frame);
        assertEquals(new Vec3(2, 1, 0), triangle.bounds().max());
    }

    @Test
    void facesThatCoincideTieExactly() {
        RandomRays random = new RandomRays(3);
        for (int i = 0; i < 20_000; i++) {
            double x = random.signed();
            Primitive box = new BoxPrimitive(new Vec3(x, -1, -1), new Vec3(x + 1, 1, 1));
            Vec3 a = new Vec3(x, -2, -2);
            Primitive wall = new RectanglePrimitive(a, new Vec3(x, 2, -2), new Vec3(x, 2, 2), new Vec3(x, -2, 2));
            Primitive half = new TrianglePrimitive(a, new Vec3(x, 7, -2), new Vec3(x, -2, 7));
            Vec3 o = new Vec3(x - random.uniform(), random.signed(), random.signed());
            Vec3 d = new Vec3(x, 0.9 * random.signed(), 0.9 * random.signed()).minus(o);
            Ray ray = Ray.of(o, d.times(0.1 + random.uniform()));
            double t = box.nearest(ray, Double.MAX_VALUE);
            assertEquals(t, wall.nearest(ray, Double.MAX_VALUE), "ray " + i);
            assertEquals(t, half.nearest(ray, Double.MAX_VALUE), "ray " + i);
        }
    }
}
