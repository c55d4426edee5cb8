package enlightenment.frame;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.math.Vec3;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

class RotationTest {
    private static final double ULP = Math.ulp(1.0);

    private final SplittableRandom random = new SplittableRandom(3);

    private double angle() {
        return 720 * (2 * random.nextDouble() - 1);
    }

    private Vec3 angles() {
        return new Vec3(angle(), angle(), angle());
    }

    private Vec3 vector() {
        return new Vec3(random.nextDouble(-1, 1), random.nextDouble(-1, 1), random.nextDouble(-1, 1));
    }

    private static void assertClose(Vec3 expected, Vec3 actual, String what) {
        assertEquals(0, expected.minus(actual).maxAbs(), 8 * ULP, what + ": " + expected + " and " + actual);
    }

    @Test
    void eachRotationTurnsItsPairOfAxes() {
        assertEquals(Vec3.Z, Rotation.aboutX(90).apply(Vec3.Y).plus(Vec3.ZERO));
        assertEquals(Vec3.X, Rotation.aboutY(90).apply(Vec3.Z).plus(Vec3.ZERO));
        assertEquals(Vec3.Y, Rotation.aboutZ(90).apply(Vec3.X).plus(Vec3.ZERO));
        assertClose(new Vec3(0, Math.sqrt(3) / 2, 0.5), Rotation.aboutX(30).apply(Vec3.Y), "30 degrees about x");
        assertClose(new Vec3(0.5, 0, Math.sqrt(3) / 2), Rotation.aboutY(30).apply(Vec3.Z), "30 degrees about y");
        assertClose(new Vec3(Math.sqrt(3) / 2, 0.5, 0), Rotation.aboutZ(30).apply(Vec3.X), "30 degrees about z");
    }

    @Test
    void multiplesOfNinetyDegreesAreExactHoweverManyTurnsTheyAre() {
        double[] sines = {0, 1, 0, -1};
        for (long k : new long[] {0, 1, 2, 3, 4, 5, -1, -2, -3, -4, 1_000_001, -999_998, 1L << 40}) {
            int q = Math.floorMod(k, 4);
            assertEquals(sines[q], Rotation.sin(90.0 * k), "sine of " + k + " quarters");
            assertEquals(sines[(q + 1) % 4], Rotation.cos(90.0 * k), "cosine of " + k + " quarters");
        }
        for (int i = 0; i < 64; i++) {
            Rotation r = Rotation.ofDegrees(new Vec3(90 * (i & 3), 90 * (i >> 2 & 3), 90 * (i >> 4)));
            for (int k = 0; k < 3; k++) {
                Vec3 axis = r.axis(k);
                // A coordinate axis of either sign: one component of absolute value 1, the others 0, exactly.
                assertEquals(1, axis.maxAbs(), "case " + i);
                assertEquals(1, axis.lengthSquared(), "case " + i);
            }
            assertEquals(r.axis(2).plus(Vec3.ZERO), r.axis(0).cross(r.axis(1)).plus(Vec3.ZERO), "case " + i);
        }
    }

    @Test
    void sineAndCosineAreThoseOfTheAngle() {
        for (int i = 0; i < 10_000; i++) {
            double degrees = angle();
            double radians = Math.toRadians(degrees);
            // The reference rounds the angle itself: by half a unit of it.
            double rounding = Math.ulp(radians) + 2 * ULP;
            assertEquals(StrictMath.sin(radians), Rotation.sin(degrees), rounding, "sine of " + degrees);
            assertEquals(StrictMath.cos(radians), Rotation.cos(degrees), rounding, "cosine of " + degrees);
        }
    }

    @Test
    void theMatrixIsOrthonormalAndKeepsTheHandedness() {
        for (int i = 0; i < 2_000; i++) {
            Rotation r = Rotation.ofDegrees(angles());
            List<Vec3> rows = List.of(r.r0(), r.r1(), r.r2());
            for (int j = 0; j < 3; j++) {
                for (int k = 0; k < 3; k++) {
                    double expected = j == k ? 1 : 0;
                    assertEquals(expected, rows.get(j).dot(rows.get(k)), 8 * ULP, "rows " + j + " and " + k);
                    assertEquals(expected, r.axis(j).dot(r.axis(k)), 8 * ULP, "columns " + j + " and " + k);
                }
            }
            assertEquals(1, r.r0().cross(r.r1()).dot(r.r2()), 8 * ULP, "determinant");
        }
    }

    @Test
    void compositionAppliesTheFirstRotationFirst() {
        for (int i = 0; i < 2_000; i++) {
            Rotation a = Rotation.ofDegrees(angles());
            Rotation b = Rotation.ofDegrees(angles());
            Vec3 v = vector();
            assertClose(a.apply(b.apply(v)), a.times(b).apply(v), "composition");
            Vec3 d = angles();
            Vec3 oneByOne = Rotation.aboutZ(d.z())
                    .apply(Rotation.aboutY(d.y()).apply(Rotation.aboutX(d.x()).apply(v)));
            assertClose(oneByOne, Rotation.ofDegrees(d).apply(v), "about x, then y, then z");
            assertEquals(v, Rotation.IDENTITY.apply(v).plus(Vec3.ZERO));
            assertClose(Vec3.X, Rotation.aboutX(d.x()).apply(Vec3.X), "the axis of rotation stays");
        }
    }

    @Test
    void rotationsAboutOneAxisAddTheirAngles() {
        for (int i = 0; i < 1_000; i++) {
            // Dyadic angles, so that their sum is exact.
            double a = random.nextInt(-1000, 1000) / 8.0;
            double b = random.nextInt(-1000, 1000) / 8.0;
            Vec3 v = vector();
            assertClose(
                    Rotation.aboutY(a + b).apply(v),
                    Rotation.aboutY(a).times(Rotation.aboutY(b)).apply(v),
                    a + " + " + b);
        }
    }

    @Test
    void anAxisIsTheImageOfACoordinateAxis() {
        Rotation r = Rotation.ofDegrees(new Vec3(10, 20, 30));
        assertEquals(r.apply(Vec3.X), r.axis(0));
        assertEquals(r.apply(Vec3.Y), r.axis(1));
        assertEquals(r.apply(Vec3.Z), r.axis(2));
        assertTrue(r.axis(0).dot(Vec3.X) > 0.5);
    }
}
