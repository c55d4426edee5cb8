package enlightenment.emitter;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.math.Vec3;
import enlightenment.sampling.Sobol;
import org.junit.jupiter.api.Test;

/** Directions into a light, chosen by their cosine, against weighted directions that are chosen evenly. */
class CosineSamplingTest {
    private static final int COUNT = 1 << 14;

    private static SphereEmitter light(double radius) {
        return new SphereEmitter(new Vec3(0.5, 1, 0.25), radius);
    }

    /** Moments of the offset from the axis, in units of the cone's sine. */
    private static double[] moments(Emitter light, EmitterView s, Vec3 n, Vec3 n2, boolean byCosine) {
        double[] sum = new double[6];
        double weights = 0;
        Vec3 w = new Vec3(s.cone.wx, s.cone.wy, s.cone.wz);
        Vec3 e = n2.minus(w.times(n2.dot(w))).normalized();
        Vec3 f = w.cross(e);
        light.prepareByCosine(s, n.x(), n.y(), n.z());
        for (int i = 0; i < COUNT; i++) {
            if (byCosine) {
                light.sampleByCosine(s, Sobol.x(i, 7), Sobol.y(i, 7));
            } else {
                light.sample(s, Sobol.x(i, 7), Sobol.y(i, 7));
            }
            Vec3 d = new Vec3(s.dx, s.dy, s.dz);
            assertEquals(1, d.length(), 1e-15);
            assertTrue(s.length > 0);
            double x = d.dot(e) / s.cone.sine;
            double y = d.dot(f) / s.cone.sine;
            assertTrue(x * x + y * y <= 1 + 1e-6);
            double weight = byCosine ? 1 : d.dot(n);
            assertTrue(weight > 0);
            double[] terms = {x, y, x * x, x * y, y * y, x * x * x};
            for (int k = 0; k < terms.length; k++) {
                sum[k] += weight * terms[k];
            }
            weights += weight;
        }
        for (int k = 0; k < sum.length; k++) {
            sum[k] /= weights;
        }
        return sum;
    }

    @Test
    void directionsByCosineHaveTheMomentsOfWeightedOnes() {
        Vec3[] normals = {
            new Vec3(0.5, 1, 0.25).normalized(), new Vec3(0.3, 1, 0.1).normalized(), new Vec3(1, 0.7, -0.3).normalized()
        };
        for (double radius : new double[] {0.7, 0.3, 1e-3, 1e-8}) {
            SphereEmitter light = light(radius);
            EmitterView s = Views.fromOrigin(light);
            for (Vec3 n : normals) {
                assertTrue(light.meanCosine(s, n.x(), n.y(), n.z()) > 0, "the light is above the horizon of " + n);
                Vec3 n2 = new Vec3(0.9, -0.2, 0.6);
                double[] expected = moments(light, s, n, n2, false);
                double[] actual = moments(light, s, n, n2, true);
                // Both are Sobol sums of smooth terms: their error falls nearly as 1/N.
                for (int k = 0; k < expected.length; k++) {
                    assertEquals(expected[k], actual[k], 2e-3, radius + " " + n + " " + k);
                }
            }
        }
    }

    @Test
    void aLightThatTouchesTheHorizonIsSampledToItsEdge() {
        SphereEmitter light = light(0.3);
        EmitterView s = Views.fromOrigin(light);
        Vec3 w = new Vec3(s.cone.wx, s.cone.wy, s.cone.wz);
        Vec3 across = w.cross(Vec3.Z).normalized();
        Vec3 n = across.times(s.cone.cosine).plus(w.times(s.cone.sine * (1 + 1e-15)));
        assertTrue(light.meanCosine(s, n.x(), n.y(), n.z()) > 0, "the light is above the horizon");
        light.prepareByCosine(s, n.x(), n.y(), n.z());
        double lowest = 1;
        double highest = 0;
        for (int i = 0; i < COUNT; i++) {
            light.sampleByCosine(s, Sobol.x(i, 7), Sobol.y(i, 7));
            Vec3 d = new Vec3(s.dx, s.dy, s.dz);
            assertEquals(1, d.length(), 1e-15);
            assertTrue(d.dot(n) > -1e-7 && d.dot(w) >= s.cone.cosine - 1e-7);
            lowest = Math.min(lowest, d.dot(n));
            highest = Math.max(highest, d.dot(n));
        }
        // The cone reaches from the horizon up to twice its half angle.
        double top = 2 * s.cone.sine * s.cone.cosine;
        assertTrue(lowest < 0.05 * top && highest > 0.98 * top, lowest + " to " + highest + " of " + top);
    }
}
