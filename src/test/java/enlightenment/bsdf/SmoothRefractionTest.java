package enlightenment.bsdf;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.math.Vec3;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** Glass with two normals: which way light goes, what is lost, and that light which is carried either way makes the same picture. */
class SmoothRefractionTest {
    private static final Vec3 SURFACE = new Vec3(0.48, -0.6, 0.64);

    private final SplittableRandom random = new SplittableRandom(38);

    private Vec3 direction() {
        while (true) {
            Vec3 v = new Vec3(signed(), signed(), signed());
            if (v.lengthSquared() < 1 && v.lengthSquared() > 0.01) {
                return v.normalized();
            }
        }
    }

    private double signed() {
        return 2 * random.nextDouble() - 1;
    }

    /** A normal up to some 40° from that of the surface. */
    private Vec3 bent() {
        return SURFACE.plus(direction().times(0.6)).normalized();
    }

    /** A place seen from a direction, of glass of index 1.5 on the side that the normals point away from. */
    private static Scattering seen(Vec3 shading, Vec3 o, boolean fromLight) {
        double side = o.dot(SURFACE) < 0 ? -1 : 1;
        Scattering s = new Scattering();
        s.nx = side * shading.x();
        s.ny = side * shading.y();
        s.nz = side * shading.z();
        s.gx = side * SURFACE.x();
        s.gy = side * SURFACE.y();
        s.gz = side * SURFACE.z();
        s.ox = o.x();
        s.oy = o.y();
        s.oz = o.z();
        s.eta = side > 0 ? 1 / 1.5 : 1.5;
        s.fromLight = fromLight;
        return s;
    }

    private boolean sample(Scattering s) {
        return SmoothRefraction.INSTANCE.sample(s, 0.5, 0.5, random.nextDouble());
    }

    private static Vec3 in(Scattering s) {
        return new Vec3(s.ix, s.iy, s.iz);
    }

    @Test
    void lightGoesBySnellsLawAboutTheShadingNormal() {
        int through = 0;
        for (int k = 0; k < 2_000; k++) {
            Vec3 n = bent();
            Vec3 o = direction();
            Scattering s = seen(n, o, false);
            if (sample(s)) {
                Vec3 expected =
                        s.transmitted ? n.cross(o).times(-s.eta) : n.cross(o).negated();
                assertEquals(0, n.cross(in(s)).minus(expected).length(), 1e-14);
                assertEquals(1, s.valueG);
                through += s.transmitted ? 1 : 0;
            }
        }
        assertTrue(through > 500 && through < 1_900, "" + through);
    }

    @Test
    void noLightLeavesToTheWrongSideOfTheSurface() {
        int lost = 0;
        for (int k = 0; k < 20_000; k++) {
            Scattering s = seen(bent(), direction(), k % 2 == 0);
            if (sample(s)) {
                assertEquals(s.transmitted, s.geometricCosineIn() < 0);
                assertTrue(s.cosineOut() > 0 && s.transmitted == s.cosineIn() < 0);
            } else {
                assertEquals(0, s.valueR);
                lost++;
            }
        }
        assertTrue(lost > 200, "" + lost);
    }

    @Test
    void lightThatIsLostIsLostTheOtherWayToo() {
        for (int k = 0; k < 20_000; k++) {
            Vec3 n = bent();
            Vec3 o = direction();
            double choice = random.nextDouble();
            Scattering s = seen(n, o, false);
            if (SmoothRefraction.INSTANCE.sample(s, 0.5, 0.5, choice)) {
                Scattering back = seen(n, in(s), true);
                assertTrue(SmoothRefraction.INSTANCE.sample(back, 0.5, 0.5, choice));
                assertEquals(0, in(back).minus(o).length(), 1e-7);
                assertEquals(s.pdf, back.pdf, 1e-7);
            }
        }
    }

    /** What eyes see of lights is what lights send to eyes: ⟨e, K l⟩ = ⟨K* e, l⟩, by the projected solid angle of the surface itself. */
    @Test
    void lightThatIsCarriedEitherWayMakesTheSamePicture() {
        for (int k = 0; k < 12; k++) {
            Vec3 n = bent();
            double[] seen = sums(n, false);
            double[] carried = sums(n, true);
            double error = Math.sqrt(seen[1] + carried[1]);
            assertEquals(seen[0], carried[0], 4.5 * error);
            assertTrue(error < 0.01 * seen[0], error + " of " + seen[0]);
        }
    }

    /** Mean and its squared error of one of the two products. */
    private double[] sums(Vec3 n, boolean fromLight) {
        int count = 400_000;
        double sum = 0;
        double squares = 0;
        for (int k = 0; k < count; k++) {
            Vec3 o = direction();
            Scattering s = seen(n, o, fromLight);
            if (sample(s)) {
                // Solid angle times cosine counts by the square of the index; radiance over that is what the interface
                // hands on.
                double area = Math.abs(o.dot(SURFACE)) * (o.dot(SURFACE) < 0 ? 1.5 * 1.5 : 1);
                Vec3 eye = fromLight ? in(s) : o;
                Vec3 light = fromLight ? o : in(s);
                double x = area * s.valueR * eyes(eye, n) * lights(light);
                sum += x;
                squares += x * x;
            }
        }
        double mean = sum / count;
        return new double[] {mean, (squares / count - mean * mean) / count};
    }

    /** Nothing along the shading normal's plane, where the weights of light paths have no bound. */
    private static double eyes(Vec3 d, Vec3 n) {
        return Math.abs(d.dot(n)) * (1.2 + d.x());
    }

    private static double lights(Vec3 d) {
        return 1.2 + d.y();
    }

    @Test
    void withOneNormalItIsSmoothGlass() {
        for (int k = 0; k < 2_000; k++) {
            Vec3 o = direction();
            double choice = random.nextDouble();
            Scattering s = seen(SURFACE, o, k % 2 == 0);
            Scattering plain = seen(SURFACE, o, k % 2 == 0);
            assertTrue(SmoothRefraction.INSTANCE.sample(s, 0.5, 0.5, choice));
            assertTrue(SmoothDielectric.INSTANCE.sample(plain, 0.5, 0.5, choice));
            assertEquals(0, in(s).minus(in(plain)).length());
            assertEquals(plain.valueR, s.valueR, 1e-15);
        }
    }

    @Test
    void whatIsSeenFromBehindTheShadingNormalIsBlack() {
        Vec3 side = SURFACE.cross(Vec3.X).normalized();
        Vec3 n = SURFACE.plus(side.times(0.8)).normalized();
        Vec3 o = SURFACE.times(0.1).minus(side).normalized();
        assertTrue(o.dot(SURFACE) > 0 && o.dot(n) < 0);
        assertFalse(sample(seen(n, o, false)));
        assertFalse(sample(seen(n, o, true)));
    }
}
