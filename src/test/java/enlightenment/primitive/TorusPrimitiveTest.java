package enlightenment.primitive;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.frame.Bounds;
import enlightenment.frame.SceneFrame;
import enlightenment.geometry.Torus;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import java.math.BigDecimal;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** The torus where its crossings are known in closed form, and under changes of unit (numerics N08, N13). */
class TorusPrimitiveTest {
    private static final double INFINITY = Double.MAX_VALUE;

    private static TorusPrimitive upright(double major, double minor) {
        return new TorusPrimitive(Vec3.ZERO, Vec3.Y, major, minor);
    }

    /** The nearest crossing from (x, y, z) along (dx, dy, dz) at or after tMin. */
    private static double nearest(TorusPrimitive torus, Vec3 o, Vec3 d, double tMin) {
        Ray ray = Ray.of(o, d);
        ray.tMin = tMin;
        return torus.nearest(ray, INFINITY);
    }

    @Test
    void aLineThroughTheCentreInTheEquatorialPlaneCrossesFourTimes() {
        Vec3[] directions = {Vec3.X, Vec3.Z, new Vec3(0.6, 0, 0.8)};
        for (double ratio : new double[] {0.25, 1e-3, 1e-6, 1e-9}) {
            TorusPrimitive torus = upright(1, ratio);
            for (Vec3 d : directions) {
                Ray ray = Ray.of(Vec3.ZERO, d);
                ray.tMin = -INFINITY;
                double[] exact = {-1 - ratio, -1 + ratio, 1 - ratio, 1 + ratio};
                for (int k = 0; k < 4; k++) {
                    double t = torus.nearest(ray, INFINITY);
                    assertEquals(exact[k], t, 8 * Math.ulp(1.0), "ratio " + ratio + " along " + d);
                    assertEquals(k % 2 == 0 ? Ray.OUTSIDE : Ray.INSIDE, torus.side(ray, t));
                    ray.tMin = Math.nextUp(t);
                }
                assertEquals(Primitive.MISS, torus.nearest(ray, INFINITY));
            }
        }
    }

    @Test
    void aLineAlongTheAxisGoesThroughTheHole() {
        assertEquals(Primitive.MISS, nearest(upright(1, 0.25), new Vec3(0, -3, 0), Vec3.Y, 0));
        assertEquals(Primitive.MISS, nearest(upright(1, 0.999), new Vec3(0, -3, 0), Vec3.Y, 0));
        assertEquals(Primitive.MISS, nearest(upright(1, 0.25), new Vec3(0.7, -3, 0), Vec3.Y, 0));
    }

    @Test
    void aHornTorusIsCrossedTwiceByALineInItsPlane() {
        TorusPrimitive horn = upright(1, 1);
        Ray ray = Ray.of(new Vec3(-5, 0, 0.5), Vec3.X);
        double half = Math.sqrt(4 - 0.25);
        double t = horn.nearest(ray, INFINITY);
        assertEquals(5 - half, t, 1e-14);
        ray.tMin = Math.nextUp(t);
        t = horn.nearest(ray, INFINITY);
        assertEquals(5 + half, t, 1e-14);
        ray.tMin = Math.nextUp(t);
        assertEquals(Primitive.MISS, horn.nearest(ray, INFINITY));
    }

    @Test
    void aHornTorusHasFiniteNormalsAtItsCentre() {
        TorusPrimitive horn = upright(1, 1);
        for (Vec3 d : new Vec3[] {Vec3.X, Vec3.Y, new Vec3(1, 1, 0), new Vec3(1, 1e-9, 0), new Vec3(0, 1, 1e-9)}) {
            Ray ray = Ray.of(d.times(-3), d);
            Hit hit = new Hit();
            ray.tMin = -INFINITY;
            int crossings = 0;
            while (horn.intersect(ray, hit)) {
                crossings++;
                assertTrue(hit.point().isFinite(), "along " + d);
                assertEquals(1, hit.normal().length(), 1e-15);
                horn.textureCoordinates(hit);
                assertTrue(hit.u >= 0 && hit.u <= 1 && hit.v >= 0 && hit.v <= 1);
                ray.tMin = Math.nextUp(hit.t);
            }
            // A line close to the axis only grazes the torus, any other one through the centre enters and leaves it.
            boolean grazes = Math.abs(d.y()) > Math.abs(d.x());
            assertTrue(grazes || crossings >= 2, crossings + " crossings along " + d);
        }
    }

    @Test
    void aPlaneThatTouchesTheTopSeparatesHitsFromMisses() {
        for (double minor : new double[] {0.25, 1e-3, 1}) {
            TorusPrimitive torus = upright(1, minor);
            for (Vec3 d : new Vec3[] {Vec3.X, Vec3.Z, new Vec3(0.3, 0, -1.7)}) {
                Vec3 o = d.times(-4);
                assertEquals(Primitive.MISS, nearest(torus, o.plus(new Vec3(0, minor + 1e-12, 0)), d, 0));
                double t = nearest(torus, o.plus(new Vec3(0, minor - 1e-12, 0)), d, 0);
                double outer = 1 + Math.sqrt(1e-12 * (2 * minor - 1e-12));
                assertEquals(4 - outer / d.length(), t, 1e-8);
            }
        }
    }

    @Test
    void theInnerEquatorIsMetFromTheHole() {
        TorusPrimitive torus = upright(2, 0.5);
        Hit hit = new Hit();
        assertTrue(torus.intersect(Ray.of(Vec3.ZERO, Vec3.X), hit));
        assertEquals(1.5, hit.t, 4 * Math.ulp(1.5));
        assertEquals(Ray.OUTSIDE, hit.side);
        assertEquals(new Vec3(-1, 0, 0), hit.normal().plus(Vec3.ZERO));
        assertEquals(0, hit.face);
        assertEquals(torus, hit.primitive);
    }

    @Test
    void aCrossingBeyondTheGivenDistanceDoesNotCount() {
        TorusPrimitive torus = upright(1, 0.25);
        Ray ray = Ray.of(new Vec3(-4, 0, 0), Vec3.X);
        double t = torus.nearest(ray, INFINITY);
        assertEquals(t, torus.nearest(ray, t));
        assertEquals(Primitive.MISS, torus.nearest(ray, Math.nextDown(t)));
        assertThrows(IllegalArgumentException.class, () -> torus.complete(Ray.of(Vec3.ZERO, Vec3.Y), 1, new Hit()));
    }

    @Test
    void theLengthOfTheDirectionChangesNoBitOfTheHitPoint() {
        Random random = new Random(1);
        int hits = 0;
        for (int i = 0; i < 1000; i++) {
            TorusPrimitive torus = new TorusPrimitive(
                    gaussian(random), gaussian(random).normalized(), 1, 0.05 + 0.95 * random.nextDouble());
            Vec3 o = gaussian(random).times(5);
            Vec3 d = gaussian(random).minus(o);
            Hit hit = new Hit();
            boolean found = torus.intersect(Ray.of(o, d), hit);
            hits += found ? 1 : 0;
            Hit other = new Hit();
            for (int j = -1000; j <= 1000; j += 50) {
                assertEquals(found, torus.intersect(Ray.of(o, d.scaledBy(j)), other), "times 2^" + j);
                if (found) {
                    assertEquals(hit.point(), other.point(), "times 2^" + j);
                    assertEquals(hit.normal(), other.normal(), "times 2^" + j);
                    assertEquals(hit.side, other.side);
                }
            }
            // A subnormal direction has lost digits, so it is another line; but a hit is on the surface all the same.
            if (i % 10 == 0 && torus.intersect(Ray.of(o, d.times(1e-310)), other)) {
                TorusTruth truth = new TorusTruth(
                        torus.center(), torus.axis(), 1, torus.minorRadius(), other.point(), torus.axis());
                double unit = Math.ulp(Math.max(torus.center().maxAbs(), 1 + torus.minorRadius()));
                assertEquals(0, truth.distanceAt(BigDecimal.ZERO), 8 * unit);
            }
        }
        assertTrue(hits > 200, "only " + hits);
    }

    @Test
    void aSceneScaledByAPowerOfTwoChangesNoBit() {
        Random random = new Random(2);
        int hits = 0;
        for (int i = 0; i < 500; i++) {
            Vec3 center = gaussian(random);
            TorusPrimitive torus =
                    new TorusPrimitive(center, gaussian(random).normalized(), 1, 0.05 + 0.95 * random.nextDouble());
            Vec3 o = gaussian(random).times(4);
            Vec3 d = center.plus(gaussian(random)).minus(o);
            Hit hit = new Hit();
            boolean found = torus.intersect(Ray.of(o, d), hit);
            hits += found ? 1 : 0;
            for (int k : new int[] {-900, -300, -60, -1, 1, 60, 300, 900}) {
                Hit other = new Hit();
                Primitive scaled = torus.scaledBy(k);
                assertEquals(found, scaled.intersect(Ray.of(o.scaledBy(k), d.scaledBy(k)), other), "times 2^" + k);
                if (found) {
                    assertEquals(hit.t, other.t, "times 2^" + k);
                    assertEquals(hit.point().scaledBy(k), other.point());
                    assertEquals(hit.normal(), other.normal());
                    sameLeaving(torus, hit, scaled, other, k, gaussian(random));
                }
            }
        }
        assertTrue(hits > 100 && hits < 450, hits + " hits");
    }

    private static void sameLeaving(Primitive torus, Hit hit, Primitive scaled, Hit other, int k, Vec3 d) {
        for (int side = -1; side <= 1; side += 2) {
            Ray leaving = Ray.leaving(hit.point(), d, torus, side);
            Ray scaledLeaving = Ray.leaving(other.point(), d.scaledBy(k), scaled, side);
            assertEquals(torus.nearest(leaving, INFINITY), scaled.nearest(scaledLeaving, INFINITY), "times 2^" + k);
        }
    }

    @Test
    void theTextureRunsToTheRightAroundTheRingAndDownTheOutside() {
        TorusPrimitive torus = upright(2, 0.5);
        // Seam at -z, as on a sphere; a viewer in front of it has +x to the right.
        assertTexture(torus, new Vec3(0, 0, -9), Vec3.Z, 0, 0.5);
        assertTexture(torus, new Vec3(9, 0, 0), new Vec3(-1, 0, 0), 0.25, 0.5);
        assertTexture(torus, new Vec3(0, 0, 9), new Vec3(0, 0, -1), 0.5, 0.5);
        assertTexture(torus, new Vec3(-9, 0, 0), Vec3.X, 0.75, 0.5);
        assertTexture(torus, new Vec3(2, 9, 0), new Vec3(0, -1, 0), 0.25, 0.25);
        assertTexture(torus, new Vec3(2, -9, 0), Vec3.Y, 0.25, 0.75);
        // 45 degrees up the outside, and up the inside.
        assertTexture(torus, new Vec3(6, 4, 0), new Vec3(-1, -1, 0), 0.25, 0.375);
        assertTexture(torus, new Vec3(0, 2, 0), new Vec3(1, -1, 0), 0.25, 0.125);
    }

    @Test
    void aTurnedTorusCarriesItsTextureAlong() {
        // With the axis along -y, up is down: to the right of the seam at -z is -x.
        TorusPrimitive turned = new TorusPrimitive(Vec3.ZERO, new Vec3(0, -1, 0), 2, 0.5);
        assertTexture(turned, new Vec3(-9, 0, 0), Vec3.X, 0.25, 0.5);
        assertTexture(turned, new Vec3(-2, 9, 0), new Vec3(0, -1, 0), 0.25, 0.75);
        // With the axis along +x, y has turned to x and x to -y; -z has stayed.
        TorusPrimitive lying = new TorusPrimitive(Vec3.ZERO, Vec3.X, 2, 0.5);
        assertTexture(lying, new Vec3(0, -9, 0), Vec3.Y, 0.25, 0.5);
        assertTexture(lying, new Vec3(9, -2, 0), new Vec3(-1, 0, 0), 0.25, 0.25);
    }

    private static void assertTexture(TorusPrimitive torus, Vec3 o, Vec3 d, double u, double v) {
        Hit hit = new Hit();
        assertTrue(torus.intersect(Ray.of(o, d), hit));
        torus.textureCoordinates(hit);
        assertEquals(u, hit.u, 1e-15);
        assertEquals(v, hit.v, 1e-15);
    }

    @Test
    void theBoundsHoldEveryHitAndAreTight() {
        Random random = new Random(3);
        int hits = 0;
        for (int i = 0; i < 300; i++) {
            TorusPrimitive torus = new TorusPrimitive(
                    gaussian(random), gaussian(random).normalized(), 1, 0.01 + 0.99 * random.nextDouble());
            Bounds bounds = torus.bounds();
            for (int k = 0; k < 3; k++) {
                double a = torus.axis().component(k);
                double half = Math.sqrt(1 - a * a) + torus.minorRadius();
                assertEquals(2 * half, bounds.extent().component(k), 1e-13);
            }
            Hit hit = new Hit();
            for (int j = 0; j < 200; j++) {
                Vec3 o = gaussian(random).times(5);
                if (torus.intersect(
                        Ray.of(o, torus.center().plus(gaussian(random)).minus(o)), hit)) {
                    assertTrue(bounds.contains(hit.point()), hit.point() + " outside " + bounds);
                    hits++;
                }
            }
        }
        assertTrue(hits > 6_000, hits + " of 60,000 rays");
    }

    @Test
    void theBoundsOfAnUprightTorusAreItsRadii() {
        Bounds bounds = upright(3, 1).bounds();
        assertEquals(4, bounds.max().x(), 16 * Math.ulp(4.0));
        assertEquals(1, bounds.max().y(), 16 * Math.ulp(1.0));
        assertEquals(-4, bounds.min().z(), 16 * Math.ulp(4.0));
        assertTrue(bounds.max().x() > 4 && bounds.max().y() > 1 && bounds.min().z() < -4);
    }

    @Test
    void theSolidIsTheTubeWithoutTheHole() {
        TorusPrimitive torus = upright(2, 0.5);
        assertTrue(torus.isSolid());
        assertTrue(torus.contains(2, 0, 0));
        assertTrue(torus.contains(2.5, 0, 0));
        assertTrue(torus.contains(0, 0.5, -2));
        assertFalse(torus.contains(0, 0, 0));
        assertFalse(torus.contains(2.5000001, 0, 0));
        assertFalse(torus.contains(1.4999999, 0, 0));
        Primitive tiny = torus.scaledBy(-1000);
        assertTrue(tiny.contains(0, 0, Math.scalb(2.4, -1000)));
        assertFalse(tiny.contains(0, 0, Math.scalb(2.6, -1000)));
        assertFalse(tiny.contains(1e300, 0, 0));
    }

    @Test
    void aPlacedTorusStandsWhereItsDescriptionSays() {
        Torus torus = new Torus(ExactPoint.of("1.5", "2.5", "-3"), new Vec3(0, 8, 0), 4, 1);
        Primitive placed = Primitives.place(torus, new SceneFrame(ExactPoint.of("1", "2", "3"), 1));
        assertArrayEquals(new double[] {0.25, 0.25, -3, 0, 1, 0, 2, 0.5}, placed.parameters());
    }

    private static Vec3 gaussian(Random random) {
        return new Vec3(random.nextGaussian(), random.nextGaussian(), random.nextGaussian());
    }
}
