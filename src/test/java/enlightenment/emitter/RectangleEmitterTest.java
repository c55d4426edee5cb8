package enlightenment.emitter;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.color.DisplayRgb;
import enlightenment.frame.LightVectors;
import enlightenment.light.Light;
import enlightenment.math.ExactPoint;
import enlightenment.sampling.Quadrature;
import enlightenment.sampling.RunningStatistics;
import enlightenment.world.light.ClassicLight;
import java.math.BigDecimal;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;

/**
 * Points on rectangle lights are chosen evenly over the area; so the solid angle of the light is the mean of
 * area · cosine at the light / distance² over them (numerics, N31: "or the area-sampling estimator is used").
 */
class RectangleEmitterTest {
    /** The rectangle of a line of the vectors: parallel to the x-y plane, seen from the origin. */
    private static ClassicLight light(Map<String, String> line) {
        BigDecimal x0 = new BigDecimal(line.get("x0"));
        BigDecimal y0 = new BigDecimal(line.get("y0"));
        BigDecimal z = new BigDecimal(line.get("z"));
        BigDecimal x1 = x0.add(new BigDecimal(line.get("w")));
        BigDecimal y1 = y0.add(new BigDecimal(line.get("h")));
        Light.Rectangle rectangle = new Light.Rectangle(
                new ExactPoint(x0, y0, z),
                new ExactPoint(x0, y1, z),
                new ExactPoint(x1, y1, z),
                new ExactPoint(x1, y0, z),
                DisplayRgb.WHITE);
        return Views.compile(rectangle);
    }

    /** What one light point says about the solid angle. */
    private static final class Estimator {
        private final Emitter emitter;
        private final EmitterView view;
        private final double area;

        Estimator(ClassicLight light) {
            emitter = light.emitter;
            view = Views.fromOrigin(emitter);
            area = light.right.length() * light.up.length();
        }

        double at(double u, double v) {
            emitter.sample(view, u, v);
            return area * Math.abs(view.dz) / (view.length * view.length);
        }
    }

    @Test
    void theMeanOverTheLightIsItsSolidAngle() {
        List<Map<String, String>> lines = LightVectors.of("rectLight");
        assertEquals(30, lines.size());
        for (Map<String, String> line : lines) {
            ClassicLight light = light(line);
            Estimator estimator = new Estimator(light);
            double[] us = grading(-light.x / light.right.x(), light.z / light.right.x());
            double[] vs = grading(-light.y / light.up.y(), light.z / light.up.y());
            double mean = integral(estimator, us, vs);
            double exact = Double.parseDouble(line.get("solidAngle"));
            // Close to the light, a point's own rounding is a part of its distance from the foot of the viewer.
            double nearness = Math.max(light.right.length(), light.up.length()) / light.z;
            double allowed = 1e-13 * Math.max(1, nearness);
            assertEquals(exact, mean, exact * allowed, line.toString());
        }
    }

    @Test
    void randomLightPointsAgreeWithTheSolidAngle() {
        SplittableRandom random = new SplittableRandom(31);
        int n = 20_000;
        int checked = 0;
        for (Map<String, String> line : LightVectors.of("rectLight")) {
            ClassicLight light = light(line);
            if (light.z < 0.02 * light.right.length()) {
                // Nearly all of the solid angle is in so few points that these samples would not meet one.
                continue;
            }
            Estimator estimator = new Estimator(light);
            RunningStatistics values = new RunningStatistics();
            for (int i = 0; i < n; i++) {
                values.add(estimator.at(random.nextDouble(), random.nextDouble()));
            }
            double exact = Double.parseDouble(line.get("solidAngle"));
            double error = Math.abs(values.mean() - exact);
            double rounding = 1e-15 * exact;
            assertTrue(error <= 4 * values.standardError() + rounding, line + ": off by " + error);
            checked++;
        }
        assertEquals(24, checked);
    }

    /** Ends of intervals of 0..1 that become finer towards the foot of the viewer, down to the viewer's height. */
    private static double[] grading(double foot, double height) {
        TreeSet<Double> ends = new TreeSet<>(List.of(0.0, 1.0));
        for (double step = 1; step > height / 4 && step > 0x1p-40; step /= 2) {
            for (double end : new double[] {foot - step, foot, foot + step}) {
                if (end > 0 && end < 1) {
                    ends.add(end);
                }
            }
        }
        return ends.stream().mapToDouble(Double::doubleValue).toArray();
    }

    private static double integral(Estimator estimator, double[] us, double[] vs) {
        double sum = 0;
        for (int i = 1; i < us.length; i++) {
            for (int j = 1; j < vs.length; j++) {
                double v0 = vs[j - 1];
                double v1 = vs[j];
                sum += Quadrature.panel(u -> Quadrature.panel(v -> estimator.at(u, v), v0, v1), us[i - 1], us[i]);
            }
        }
        return sum;
    }
}
