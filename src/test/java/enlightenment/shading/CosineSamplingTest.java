package enlightenment.shading;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.camera.Camera;
import enlightenment.color.DisplayRgb;
import enlightenment.compiled.CompiledLight;
import enlightenment.compiled.SceneCompiler;
import enlightenment.light.Light;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.sampling.Sobol;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import org.junit.jupiter.api.Test;

/** Directions into a light, chosen by their cosine, against weighted directions that are chosen evenly. */
class CosineSamplingTest {
    private static final int COUNT = 1 << 14;

    private static CompiledLight light(double radius) {
        Scene scene = Scene.builder()
                .camera(new Camera.Perspective(ExactPoint.ORIGIN, ExactPoint.of(0, 0, 1), Vec3.Y, 40))
                .light(new Light.Sphere(ExactPoint.of(0.5, 1, 0.25), radius, DisplayRgb.WHITE))
                .build();
        return SceneCompiler.compile(scene, RenderSettings.of(scene)).lights[0];
    }

    /** Moments of the offset from the axis, in units of the cone's sine. */
    private static double[] moments(LightSampler s, Vec3 n, Vec3 n2, boolean byCosine) {
        double[] sum = new double[6];
        double weights = 0;
        Vec3 w = new Vec3(s.cone.wx, s.cone.wy, s.cone.wz);
        Vec3 e = n2.minus(w.times(n2.dot(w))).normalized();
        Vec3 f = w.cross(e);
        s.prepareByCosine(n.x(), n.y(), n.z());
        for (int i = 0; i < COUNT; i++) {
            if (byCosine) {
                s.sampleByCosine(Sobol.x(i, 7), Sobol.y(i, 7));
            } else {
                s.sample(Sobol.x(i, 7), Sobol.y(i, 7));
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
            LightSampler s = new LightSampler();
            s.aim(light(radius), 0, 0, 0);
            for (Vec3 n : normals) {
                assertTrue(s.meanCosine(n.x(), n.y(), n.z()) > 0, "the light is above the horizon of " + n);
                Vec3 n2 = new Vec3(0.9, -0.2, 0.6);
                double[] expected = moments(s, n, n2, false);
                double[] actual = moments(s, n, n2, true);
                // Both are Sobol sums of smooth terms: their error falls nearly as 1/N.
                for (int k = 0; k < expected.length; k++) {
                    assertEquals(expected[k], actual[k], 2e-3, radius + " " + n + " " + k);
                }
            }
        }
    }

    @Test
    void aLightThatTouchesTheHorizonIsSampledToItsEdge() {
        LightSampler s = new LightSampler();
        s.aim(light(0.3), 0, 0, 0);
        Vec3 w = new Vec3(s.cone.wx, s.cone.wy, s.cone.wz);
        Vec3 across = w.cross(Vec3.Z).normalized();
        Vec3 n = across.times(s.cone.cosine).plus(w.times(s.cone.sine * (1 + 1e-15)));
        assertTrue(s.meanCosine(n.x(), n.y(), n.z()) > 0, "the light is above the horizon");
        s.prepareByCosine(n.x(), n.y(), n.z());
        double lowest = 1;
        double highest = 0;
        for (int i = 0; i < COUNT; i++) {
            s.sampleByCosine(Sobol.x(i, 7), Sobol.y(i, 7));
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
