package enlightenment.bsdf;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.math.Vec3;
import enlightenment.sampling.ChiSquare;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** Value, samples and densities of every kind of surface agree with each other and with what physics asks of them. */
class BsdfTest {
    private static final double ULP = Math.ulp(1.0);
    private static final List<Bsdf> DELTA = List.of(SpecularReflection.INSTANCE, ClassicDielectric.INSTANCE);
    private static final List<Vec3> NORMALS = List.of(
            Vec3.Z,
            Vec3.Z.negated(),
            Vec3.X,
            Vec3.Y.negated(),
            new Vec3(0.3, -0.7, 0.2).normalized(),
            new Vec3(1e-9, 0, -1));

    private final SplittableRandom random = new SplittableRandom(41);

    private Vec3 direction() {
        Vec3 v;
        do {
            v = new Vec3(signed(), signed(), signed());
        } while (v.lengthSquared() > 1 || v.lengthSquared() < 0.01);
        return v.normalized();
    }

    private double signed() {
        return 2 * random.nextDouble() - 1;
    }

    private static Scattering at(Vec3 n, Vec3 o) {
        Scattering s = new Scattering();
        s.nx = n.x();
        s.ny = n.y();
        s.nz = n.z();
        from(s, o);
        return s;
    }

    private static void from(Scattering s, Vec3 o) {
        s.ox = o.x();
        s.oy = o.y();
        s.oz = o.z();
    }

    private static void towards(Scattering s, Vec3 i) {
        s.ix = i.x();
        s.iy = i.y();
        s.iz = i.z();
    }

    private static Vec3 in(Scattering s) {
        return new Vec3(s.ix, s.iy, s.iz);
    }

    /** A direction on the normal's side. */
    private Vec3 above(Vec3 n) {
        Vec3 d = direction();
        return d.dot(n) < 0 ? d.negated() : d;
    }

    @Test
    void aSamplesDensityIsThatOfItsDirectionAndItsWeightIsValueOverDensity() {
        for (Vec3 n : NORMALS) {
            for (int k = 0; k < 1_000; k++) {
                Scattering s = at(n, above(n));
                s.red = 0.8;
                s.green = 0.5;
                s.blue = 0;
                if (!Lambert.INSTANCE.sample(s, random.nextDouble(), random.nextDouble(), random.nextDouble())) {
                    continue;
                }
                assertEquals(1, in(s).length(), 2 * ULP);
                assertTrue(in(s).dot(n) > 0 && !s.delta && !s.transmitted);
                assertEquals(s.pdf, Lambert.INSTANCE.pdf(s));
                double r = s.valueR * s.pdf;
                double g = s.valueG * s.pdf;
                Lambert.INSTANCE.evaluate(s);
                assertEquals(s.valueR, r, 1e-15 * r);
                assertEquals(s.valueG, g, 1e-15 * g);
                assertEquals(0, s.valueB);
            }
        }
    }

    @Test
    void samplesAreDistributedAsTheirDensitySays() {
        int rings = 10;
        int sectors = 20;
        int samples = 50_000;
        for (Vec3 n : NORMALS) {
            Vec3 e = (Math.abs(n.x()) < 0.9 ? Vec3.X : Vec3.Y).cross(n).normalized();
            Vec3 f = n.cross(e);
            // The density is integrated over each cell of height and angle by its midpoints: exact to 1e-4.
            double[] expected = new double[rings * sectors];
            Scattering s = at(n, n);
            int fine = 40;
            for (int i = 0; i < rings * fine; i++) {
                double mu = (i + 0.5) / (rings * fine);
                towards(s, n.times(mu).plus(e.times(Math.sqrt(1 - mu * mu))));
                double share = Lambert.INSTANCE.pdf(s) * 2 * Math.PI / (rings * fine) / sectors;
                for (int j = 0; j < sectors; j++) {
                    expected[i / fine * sectors + j] += samples * share;
                }
            }
            int[] counts = new int[rings * sectors];
            for (int k = 0; k < samples; k++) {
                assertTrue(Lambert.INSTANCE.sample(s, random.nextDouble(), random.nextDouble(), 0));
                Vec3 i = in(s);
                double turn = Math.atan2(i.dot(f), i.dot(e)) / (2 * Math.PI) + 0.5;
                int ring = Math.min((int) (rings * i.dot(n)), rings - 1);
                counts[ring * sectors + Math.min((int) (sectors * turn), sectors - 1)]++;
            }
            ChiSquare.check(expected, counts, "normal " + n);
        }
    }

    @Test
    void theDensityIsOneInAllAndAWhiteSurfaceReflectsAllThatArrives() {
        Scattering s = at(Vec3.Z, Vec3.Z);
        int steps = 2_000;
        double density = 0;
        double albedo = 0;
        for (int k = 0; k < steps; k++) {
            double mu = 2 * (k + 0.5) / steps - 1;
            towards(s, new Vec3(Math.sqrt(1 - mu * mu), 0, mu));
            density += Lambert.INSTANCE.pdf(s) * 2 * Math.PI * 2 / steps;
            Lambert.INSTANCE.evaluate(s);
            albedo += s.valueG * 2 * Math.PI * 2 / steps;
        }
        assertEquals(1, density, 1e-12);
        assertEquals(1, albedo, 1e-12);
        // Sampled, it does so for every single path, of whatever kind the surface is.
        for (Bsdf bsdf : List.of(Lambert.INSTANCE, SpecularReflection.INSTANCE, ClassicDielectric.INSTANCE)) {
            for (int k = 0; k < 1_000; k++) {
                Scattering white = at(Vec3.Z, above(Vec3.Z));
                white.eta = k % 2 == 0 ? 1.5 : 1 / 1.5;
                assertTrue(bsdf.sample(white, random.nextDouble(), random.nextDouble(), random.nextDouble()));
                assertEquals(1, white.valueR);
                assertEquals(1, white.valueG);
                assertEquals(1, white.valueB);
            }
        }
    }

    @Test
    void theValueIsTheSameBothWays() {
        Vec3 n = new Vec3(0.3, -0.7, 0.2).normalized();
        for (int k = 0; k < 1_000; k++) {
            Vec3 a = above(n);
            Vec3 b = above(n);
            Scattering s = at(n, a);
            towards(s, b);
            Lambert.INSTANCE.evaluate(s);
            double there = s.valueR / b.dot(n);
            from(s, b);
            towards(s, a);
            Lambert.INSTANCE.evaluate(s);
            assertEquals(there, s.valueR / a.dot(n), there * 8 * ULP / Math.min(a.dot(n), b.dot(n)));
            towards(s, a.negated());
            Lambert.INSTANCE.evaluate(s);
            assertEquals(0, s.valueR, "nothing goes through");
            assertEquals(0, Lambert.INSTANCE.pdf(s));
        }
    }

    @Test
    void noDirectionThatSomebodyChoseIsThatOfADeltaLobe() {
        for (Bsdf bsdf : DELTA) {
            assertTrue(bsdf.isDelta());
            Scattering s = at(Vec3.Z, new Vec3(0.6, 0, 0.8));
            s.eta = 1 / 1.5;
            assertTrue(bsdf.sample(s, 0.2, 0.3, 0.4));
            assertTrue(s.delta);
            assertEquals(1, s.pdf, "the probability");
            assertEquals(0, bsdf.pdf(s), "the density");
            bsdf.evaluate(s);
            assertEquals(0, s.valueR + s.valueG + s.valueB);
        }
        assertFalse(Lambert.INSTANCE.isDelta());
    }

    @Test
    void aMirrorsDirectionsAreMirrorImagesAndItsWeightIsItsColour() {
        for (int k = 0; k < 1_000; k++) {
            Vec3 n = direction();
            Vec3 o = above(n);
            Scattering s = at(n, o);
            s.red = 0.25;
            assertTrue(SpecularReflection.INSTANCE.sample(s, 0, 0, 0));
            Vec3 i = in(s);
            assertEquals(0, i.plus(o).minus(n.times(2 * o.dot(n))).length(), 8 * ULP);
            assertEquals(0.25, s.valueR);
            assertEquals(1, s.valueG);
            assertFalse(s.transmitted);
            from(s, i);
            assertTrue(SpecularReflection.INSTANCE.sample(s, 0, 0, 0));
            assertEquals(0, in(s).minus(o).length(), 8 * ULP);
        }
    }

    @Test
    void glassBendsBySnellsLawAndTheWayBackIsTheSame() {
        int total = 0;
        for (int k = 0; k < 2_000; k++) {
            Vec3 n = direction();
            Vec3 o = above(n);
            Scattering s = at(n, o);
            s.eta = k % 2 == 0 ? 1 / 1.5 : 1.5;
            assertTrue(ClassicDielectric.INSTANCE.sample(s, 0, 0, 0));
            Vec3 i = in(s);
            double sine = s.eta * o.cross(n).length();
            assertEquals(sine <= 1, s.transmitted);
            total += s.transmitted ? 0 : 1;
            if (s.transmitted) {
                // η (n × o) = −(n × i): in one plane, on the other side, with the sines of Snell's law.
                assertEquals(0, n.cross(o).times(s.eta).plus(n.cross(i)).length(), 8 * ULP);
                assertTrue(i.dot(n) < 0);
                Scattering back = at(n.negated(), i);
                back.eta = 1 / s.eta;
                assertTrue(ClassicDielectric.INSTANCE.sample(back, 0, 0, 0));
                // A sine that is rounded moves a grazing direction by that over its cosine.
                assertEquals(0, in(back).minus(o).length(), 8 * ULP / Math.min(-i.dot(n), o.dot(n)));
            } else {
                assertEquals(0, i.plus(o).minus(n.times(2 * o.dot(n))).length(), 8 * ULP);
            }
        }
        assertTrue(total > 100, total + " reflected totally");
    }

    @Test
    void radianceIsDenserInDenserGlassByTheSquareOfTheIndexAndImportanceIsNot() {
        Scattering s = at(Vec3.Z, new Vec3(0.28, 0, 0.96));
        for (double eta : new double[] {1 / 1.5, 1.5}) {
            s.eta = eta;
            s.radiance = true;
            assertTrue(ClassicDielectric.INSTANCE.sample(s, 0, 0, 0));
            assertEquals(eta * eta, s.valueG, 1e-15);
            s.radiance = false;
            assertTrue(ClassicDielectric.INSTANCE.sample(s, 0, 0, 0));
            assertEquals(1, s.valueG);
        }
        // What is reflected stays where it is.
        from(s, new Vec3(0.96, 0, 0.28));
        s.radiance = true;
        assertTrue(ClassicDielectric.INSTANCE.sample(s, 0, 0, 0));
        assertFalse(s.transmitted);
        assertEquals(1, s.valueG);
    }
}
