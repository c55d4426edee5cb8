package enlightenment.primitive;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.frame.SceneFrame;
import enlightenment.geometry.Sphere;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class SpherePrimitiveTest {
    private final Primitive unit = new SpherePrimitive(Vec3.ZERO, 1, new Vec3(0, 0, -1));

    @Test
    void aRayEntersLeavesOrPasses() {
        Hit hit = new Hit();
        assertTrue(unit.intersect(Ray.of(new Vec3(0, 0, -3), new Vec3(0, 0, 2)), hit));
        assertEquals(1, hit.t);
        assertEquals(new Vec3(0, 0, -1), hit.point().plus(Vec3.ZERO));
        assertEquals(Ray.OUTSIDE, hit.side);
        assertTrue(unit.intersect(Ray.of(Vec3.ZERO, new Vec3(0, 0, 2)), hit));
        assertEquals(0.5, hit.t);
        assertEquals(Ray.INSIDE, hit.side);
        assertEquals(Primitive.MISS, unit.nearest(Ray.of(new Vec3(0, 0, 3), Vec3.Z), 9));
        assertEquals(Primitive.MISS, unit.nearest(Ray.of(new Vec3(0, 1.5, -3), Vec3.Z), 9));
        assertEquals(Primitive.MISS, unit.nearest(Ray.of(new Vec3(0, 0, -3), Vec3.Z), 1.9));
    }

    @Test
    void aCrossingBeforeTheRaysRangeDoesNotCount() {
        Ray ray = new Ray().set(0, 0, -3, 0, 0, 1, 2.5);
        assertEquals(4, unit.nearest(ray, 9));
        Hit hit = new Hit();
        unit.complete(ray, 4, hit);
        assertEquals(Ray.INSIDE, hit.side);
        assertEquals(1, hit.pz);
    }

    @ParameterizedTest
    @ValueSource(doubles = {1e-6, 1, 1e6})
    void aGapOfAnyWidthIsMeasuredToTheLastDigits(double r) {
        for (int k = 1; k <= 13; k++) {
            double bottom = r * Math.pow(10, -k);
            Primitive ball = new SpherePrimitive(new Vec3(0, r + bottom, 0), r, new Vec3(0, 0, -1));
            // What is left of the gap once the centre is rounded, exactly: Sterbenz.
            double gap = (r + bottom) - r;
            double t = ball.nearest(Ray.of(Vec3.ZERO, Vec3.Y), Double.MAX_VALUE);
            assertEquals(gap, t, 1e-15 * r, "k = " + k);
        }
    }

    @Test
    void aSphereThatTouchesTheFloorLetsNoLightThroughTheContact() {
        for (double r : new double[] {1e-6, 0.7, 1, 3e5}) {
            Primitive ball = new SpherePrimitive(new Vec3(0, r, 0), r, new Vec3(0, 0, -1));
            for (int k = 0; k <= 15; k++) {
                Vec3 o = new Vec3(r * Math.pow(10, -k) * 0.99, 0, 0);
                Vec3 light = new Vec3(0, 10 * r, 0);
                assertTrue(ball.nearest(Ray.of(o, Vec3.Y), Double.MAX_VALUE) != Primitive.MISS);
                assertTrue(ball.nearest(Ray.of(o, light.minus(o)), 1) != Primitive.MISS);
            }
        }
    }

    @Test
    void rotationTurnsTheTexture() {
        Hit hit = new Hit();
        Primitive turned = Primitives.place(new Sphere(ExactPoint.ORIGIN, 1, 90), SceneFrame.WORLD);
        // About +y by 90 degrees, z turns towards x: the seam moves from -z to -x.
        assertTrue(turned.intersect(Ray.of(new Vec3(-3, 0, 0), Vec3.X), hit));
        turned.textureCoordinates(hit);
        assertEquals(0, hit.u, 1e-15);
        assertTrue(turned.intersect(Ray.of(new Vec3(0, 0, -3), Vec3.Z), hit));
        turned.textureCoordinates(hit);
        assertEquals(0.25, hit.u, 1e-15);
    }
}
