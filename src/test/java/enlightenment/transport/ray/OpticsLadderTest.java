package enlightenment.transport.ray;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.bsdf.Bsdf;
import enlightenment.bsdf.ClassicDielectric;
import enlightenment.bsdf.Scattering;
import enlightenment.bsdf.SpecularReflection;
import enlightenment.frame.SceneFrame;
import enlightenment.geometry.Rectangle;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.primitive.Hit;
import enlightenment.primitive.Primitives;
import enlightenment.primitive.Ray;
import java.math.BigDecimal;
import java.math.MathContext;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** Refraction and reflection against exact arithmetic (numerics, N26, N27, N28). */
class OpticsLadderTest {
    private static final double U = 0x1p-53;
    private static final MathContext DIGITS = new MathContext(60);

    /** A hit at the origin of a surface that faces +z, arrived at from there. */
    private static Hit hit() {
        return hit(0, 0, 1);
    }

    private static Hit hit(double nx, double ny, double nz) {
        Hit h = new Hit();
        h.nx = nx;
        h.ny = ny;
        h.nz = nz;
        h.side = Ray.OUTSIDE;
        h.primitive = Primitives.place(
                new Rectangle(
                        ExactPoint.of(0, 0, 0), ExactPoint.of(0, 1, 0), ExactPoint.of(1, 1, 0), ExactPoint.of(1, 0, 0)),
                SceneFrame.WORLD);
        return h;
    }

    private static Ray towards(double x, double y, double z) {
        return Ray.of(new Vec3(-x, -y, -z), new Vec3(x, y, z));
    }

    private static boolean refract(Ray ray, Hit hit, double eta) {
        Scattering s = new Scattering();
        s.eta = eta;
        scatter(ray, hit, s, ClassicDielectric.INSTANCE);
        return s.transmitted;
    }

    private static void reflect(Ray ray, Hit hit) {
        scatter(ray, hit, new Scattering(), SpecularReflection.INSTANCE);
    }

    private static void scatter(Ray ray, Hit hit, Scattering s, Bsdf bsdf) {
        Optics.arrive(s, ray, hit);
        assertTrue(bsdf.sample(s, 0, 0, 0));
        Optics.leave(ray, hit, s);
    }

    /** 1 − η²(1 − c²) for the cosine that the ray's doubles really have: negative where reflection is total. */
    private static BigDecimal exactCosineSquared(Ray ray, BigDecimal eta) {
        BigDecimal x = new BigDecimal(ray.dx);
        BigDecimal y = new BigDecimal(ray.dy);
        BigDecimal z = new BigDecimal(ray.dz);
        BigDecimal across = x.multiply(x).add(y.multiply(y));
        BigDecimal sine2 = across.divide(across.add(z.multiply(z)), DIGITS);
        return BigDecimal.ONE.subtract(eta.multiply(eta).multiply(sine2), DIGITS);
    }

    @Test
    void theLadderAroundTheCriticalAngleTakesTheRightBranchWithTheRightCosine() {
        double eta = 1.5;
        double critical = Math.sqrt(1 - 1 / (eta * eta));
        double worst = 0;
        for (int k = 1; k <= 14; k++) {
            double step = Math.pow(10, -k);
            for (int turn = 0; turn < 100; turn++) {
                double cos = critical * (1 + (turn % 2 == 0 ? step : -step));
                double sin = Math.sqrt((1 - cos) * (1 + cos));
                Ray ray = towards(sin * Math.cos(turn), sin * Math.sin(turn), -cos);
                BigDecimal exact = exactCosineSquared(ray, new BigDecimal(eta));
                assertEquals(turn % 2 == 0, exact.signum() > 0, "the ladder's own rounding, k = " + k);
                assertEquals(exact.signum() > 0, refract(ray, hit(), eta), "k = " + k);
                if (exact.signum() > 0) {
                    double t = exact.sqrt(DIGITS).doubleValue();
                    double error = Math.abs(-ray.dz - t) / t / (U / step);
                    worst = Math.max(worst, error);
                    assertTrue(error <= 8, "k = " + k + ": " + error + " u·10^k");
                }
            }
        }
        assertTrue(worst > 0);
    }

    @Test
    void anIndexOfOneBendsNothing() {
        Random r = new Random(1);
        for (int i = 0; i < 10_000; i++) {
            Vec3 d = new Vec3(r.nextGaussian(), r.nextGaussian(), -Math.abs(r.nextGaussian())).normalized();
            Ray ray = towards(d.x(), d.y(), d.z());
            assertTrue(refract(ray, hit(), 1));
            assertEquals(d.x(), ray.dx, 4 * U);
            assertEquals(d.y(), ray.dy, 4 * U);
            assertEquals(d.z(), ray.dz, 4 * U);
        }
    }

    @Test
    void intoAnEnormousIndexEverythingGoesAlongTheNormalAndOutOfItAlmostNothing() {
        Random r = new Random(2);
        int through = 0;
        int total = 0;
        for (int i = 0; i < 10_000; i++) {
            double cos = i == 0 ? 1 : Math.max(r.nextDouble(), 1e-12);
            double sin = Math.sqrt((1 - cos) * (1 + cos));
            Ray into = towards(sin, 0, -cos);
            assertTrue(refract(into, hit(), 1 / 1e6));
            assertTrue(-into.dz > 1 - 1e-12);
            assertEquals(sin * 1e-6, into.dx, 1e-6 * 8 * U);
            double sine = 1e-6 * (i % 2 == 0 ? 1 - r.nextDouble() : 1 + r.nextDouble());
            Ray out = towards(sine, 0, -Math.sqrt((1 - sine) * (1 + sine)));
            boolean exact =
                    exactCosineSquared(out, BigDecimal.valueOf(1_000_000)).signum() > 0;
            // The cosine of so small an angle is rounded at 1e-16: its sine is known to 1e-4 of 1e-6 only.
            if (Math.abs(sine - 1e-6) > 2.5e-4 * 1e-6) {
                assertEquals(exact, refract(out, hit(), 1e6), "sine " + sine);
                through += exact ? 1 : 0;
                total += exact ? 0 : 1;
            }
        }
        assertTrue(through > 4_900 && total > 4_900, through + " through, " + total + " totally reflected");
    }

    @Test
    void extremeRatiosGiveAUnitDirectionOrTotalReflection() {
        Random r = new Random(3);
        int refracted = 0;
        int reflected = 0;
        double[] ratios = {
            1 + 1e-15,
            1 - 1e-15,
            0.5,
            2,
            1e6,
            1e-6,
            1e100,
            1e-100,
            1e300,
            1e-300,
            Double.MIN_VALUE,
            0,
            Double.MAX_VALUE,
            Double.POSITIVE_INFINITY
        };
        for (double eta : ratios) {
            for (int i = 0; i < 2_000; i++) {
                Vec3 n = new Vec3(r.nextGaussian(), r.nextGaussian(), r.nextGaussian()).normalized();
                Vec3 d = new Vec3(r.nextGaussian(), r.nextGaussian(), r.nextGaussian()).normalized();
                d = d.dot(n) > 0 ? d.negated() : d;
                Ray ray = towards(d.x(), d.y(), d.z());
                if (refract(ray, hit(n.x(), n.y(), n.z()), eta)) {
                    assertEquals(1, ray.dd, 8 * U, "eta " + eta);
                    assertTrue(ray.dx * n.x() + ray.dy * n.y() + ray.dz * n.z() <= 4 * U, "eta " + eta);
                    assertEquals(Ray.INSIDE, ray.startSide);
                    refracted++;
                } else {
                    reflected++;
                    assertTrue(eta > 1, "eta " + eta);
                    assertEquals(Ray.OUTSIDE, ray.startSide);
                    assertEquals(1, ray.dd, 8 * U, "eta " + eta);
                    assertTrue(ray.dx * n.x() + ray.dy * n.y() + ray.dz * n.z() >= -4 * U, "eta " + eta);
                }
            }
        }
        assertTrue(refracted > 10_000 && reflected > 5_000, refracted + " refracted, " + reflected + " reflected");
    }

    @Test
    void aMillionReflectionsKeepTheDirectionsLengthAndItsLine() {
        Vec3 d = new Vec3(0.3, -0.5, 0.7).normalized();
        Ray ray = towards(d.x(), d.y(), d.z());
        Hit front = hit(0, 0, -1);
        Hit back = hit(0, 0, 1);
        for (int i = 0; i < 1_000_000; i++) {
            reflect(ray, i % 2 == 0 ? front : back);
        }
        assertEquals(1, Math.sqrt(ray.dd), 1e-15);
        Vec3 n = new Vec3(1, 2, -2).normalized();
        Hit tilted = hit(n.x(), n.y(), n.z());
        for (int i = 0; i < 1_000_000; i++) {
            tilted.side = ray.dx * n.x() + ray.dy * n.y() + ray.dz * n.z() < 0 ? Ray.OUTSIDE : Ray.INSIDE;
            reflect(ray, tilted);
        }
        assertEquals(1, Math.sqrt(ray.dd), 1e-15);
        assertEquals(Math.abs(d.z()), Math.abs(ray.dz), 1e-9);
    }
}
