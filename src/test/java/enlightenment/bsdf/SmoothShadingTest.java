package enlightenment.bsdf;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.color.Rgb;
import enlightenment.math.Vec3;
import enlightenment.sampling.DirectionChiSquare;
import enlightenment.sampling.SphereCells;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;

/** A surface with two normals: what it scatters, where, and that light which is carried either way makes the same picture. */
class SmoothShadingTest {
    private static final Vec3 SURFACE = new Vec3(0.48, -0.6, 0.64);

    private final SplittableRandom random = new SplittableRandom(12);

    private static Map<String, Bsdf> inner() {
        Map<String, Bsdf> all = new TreeMap<>();
        all.put("matte", Lambert.INSTANCE);
        all.put("rough matte", new RoughDiffuse(0.7));
        all.put("coat", new SmoothCoating(1.5, true));
        all.put("rough coat", new RoughCoating(0.4, 1.5, false));
        all.put("glossy", new GlossyReflection(0.5, Fresnel.SCHLICK, true));
        all.put(
                "metal",
                new GlossyReflection(
                        0.6, Fresnel.conductor(new Rgb(0.14, 0.37, 1.44), new Rgb(3.98, 2.38, 1.6)), true));
        return all;
    }

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

    /** A direction on the outside of the surface. */
    private Vec3 above() {
        Vec3 d = direction();
        return d.dot(SURFACE) < 0 ? d.negated() : d;
    }

    /** A normal up to some 60° from that of the surface. */
    private Vec3 bent(double most) {
        return SURFACE.plus(direction().times(most * random.nextDouble())).normalized();
    }

    private static Scattering at(Vec3 shading, Vec3 o) {
        Scattering s = new Scattering();
        s.red = 0.9;
        s.green = 0.5;
        s.blue = 0.2;
        s.nx = shading.x();
        s.ny = shading.y();
        s.nz = shading.z();
        s.gx = SURFACE.x();
        s.gy = SURFACE.y();
        s.gz = SURFACE.z();
        s.ox = o.x();
        s.oy = o.y();
        s.oz = o.z();
        return s;
    }

    private static Scattering to(Scattering s, Vec3 i) {
        s.ix = i.x();
        s.iy = i.y();
        s.iz = i.z();
        return s;
    }

    @Test
    void withOneNormalItIsWhatItIsMadeOf() {
        inner().forEach((name, bsdf) -> {
            SmoothShading smooth = new SmoothShading(bsdf);
            for (int k = 0; k < 2_000; k++) {
                Vec3 o = above();
                Scattering a = to(at(SURFACE, o), direction());
                Scattering b = to(at(SURFACE, o), new Vec3(a.ix, a.iy, a.iz));
                b.fromLight = k % 2 == 0;
                bsdf.evaluate(a);
                smooth.evaluate(b);
                assertEquals(a.valueR, b.valueR, 1e-13 * a.valueR, name);
                assertEquals(a.valueB, b.valueB, 1e-13 * a.valueB, name);
                assertEquals(a.pdf, b.pdf, 1e-13 * a.pdf, name);
                double u = random.nextDouble();
                double v = random.nextDouble();
                double choice = random.nextDouble();
                assertEquals(bsdf.sample(a, u, v, choice), smooth.sample(b, u, v, choice), name);
                assertEquals(a.valueG, b.valueG, 1e-12 * a.valueG, name);
                assertEquals(a.pdf, b.pdf, 1e-13 * a.pdf, name);
                assertEquals(a.delta, b.delta, name);
            }
        });
    }

    @Test
    void noLightPassesTheTriangle() {
        inner().forEach((name, bsdf) -> {
            SmoothShading smooth = new SmoothShading(bsdf);
            for (int k = 0; k < 2_000; k++) {
                Scattering s = at(bent(1), k % 3 == 0 ? above().negated() : above());
                to(s, k % 3 == 0 ? above() : above().negated());
                s.fromLight = k % 2 == 0;
                smooth.evaluate(s);
                assertEquals(0, s.valueR + s.valueG + s.valueB + s.pdf, name);
                assertEquals(0, smooth.pdf(s), name);
            }
        });
        assertFalse(new SmoothShading(Lambert.INSTANCE).transmits());
    }

    /** Veach, 1997, 5.3: what a path from the light carries, by the true cosine of where it goes, is what one from the eye does by its own. */
    @Test
    void lightIsTheSameWhicheverWayItIsCarried() {
        inner().forEach((name, bsdf) -> {
            SmoothShading smooth = new SmoothShading(bsdf);
            int lit = 0;
            for (int k = 0; k < 5_000; k++) {
                Vec3 light = above();
                Vec3 eye = above();
                Vec3 shading = bent(k % 2 == 0 ? 0.5 : 1);
                Scattering s = to(at(shading, eye), light);
                smooth.evaluate(s);
                double seen = s.valueG / light.dot(SURFACE);
                s = to(at(shading, light), eye);
                s.fromLight = true;
                smooth.evaluate(s);
                double carried = s.valueG / eye.dot(SURFACE);
                assertEquals(seen, carried, 1e-10 * seen, name);
                lit += seen > 0 ? 1 : 0;
            }
            assertTrue(lit > 3_000, name + ": " + lit);
        });
    }

    /** Mirror images are adjoint, too: their directions have equal solid angles both ways. */
    @Test
    void aMirrorImageIsTheSameWhicheverWayItIsCarried() {
        SmoothShading smooth = new SmoothShading(SpecularReflection.INSTANCE);
        int reflected = 0;
        for (int k = 0; k < 5_000; k++) {
            Vec3 eye = above();
            Vec3 shading = bent(0.7);
            Scattering s = at(shading, eye);
            if (eye.dot(shading) <= 0 || !smooth.sample(s, 0.5, 0.5, 0.5)) {
                continue;
            }
            assertTrue(s.delta && s.pdf == 1);
            Vec3 light = new Vec3(s.ix, s.iy, s.iz);
            double seen = s.valueG / light.dot(SURFACE);
            s = at(shading, light);
            s.fromLight = true;
            assertTrue(smooth.sample(s, 0.5, 0.5, 0.5));
            assertEquals(0, new Vec3(s.ix, s.iy, s.iz).minus(eye).maxAbs(), 1e-14);
            assertEquals(seen, s.valueG / eye.dot(SURFACE), 1e-9 * seen);
            reflected++;
        }
        assertTrue(reflected > 2_000);
    }

    @Test
    void samplesDensitiesAndWeightsBelongTogether() {
        inner().forEach((name, bsdf) -> {
            SmoothShading smooth = new SmoothShading(bsdf);
            int found = 0;
            for (int k = 0; k < 5_000; k++) {
                Scattering s = at(bent(1), above());
                s.fromLight = k % 2 == 0;
                if (!smooth.sample(s, random.nextDouble(), random.nextDouble(), random.nextDouble()) || s.delta) {
                    continue;
                }
                found++;
                assertTrue(s.geometricCosineIn() > 0, name);
                double p = s.pdf;
                double r = s.valueR * p;
                double b = s.valueB * p;
                assertEquals(p, smooth.pdf(s), 1e-9 * p, name);
                smooth.evaluate(s);
                assertEquals(p, s.pdf, 1e-9 * p, name);
                assertEquals(r, s.valueR, 1e-9 * r, name);
                assertEquals(b, s.valueB, 1e-9 * b, name);
            }
            assertTrue(found > 1_500, name + ": " + found);
        });
    }

    /** As it is seen by its normal, and from where that turns away. */
    @Test
    void directionsAreDistributedAsTheDensitySays() {
        long seed = 1;
        for (Map.Entry<String, Bsdf> entry : inner().entrySet()) {
            SmoothShading smooth = new SmoothShading(entry.getValue());
            for (double cosine : new double[] {0.8, 0.2}) {
                Place place = Place.seen(smooth, cosine);
                Vec3 n = place.normal();
                place.s.gx = n.x();
                place.s.gy = n.y();
                place.s.gz = n.z();
                Vec3 shading = n.minus(place.o().times(cosine < 0.5 ? 0.5 : -0.3))
                        .plus(Vec3.X.times(0.3))
                        .normalized();
                place.s.nx = shading.x();
                place.s.ny = shading.y();
                place.s.nz = shading.z();
                assertEquals(cosine < 0.5, shading.dot(place.o()) < 0);
                place.s.fromLight = cosine < 0.5;
                SphereCells cells = new SphereCells(n, 1, 24, 48);
                double total = DirectionChiSquare.check(
                        place, cells, entry.getValue().hasDelta() ? 80_000 : 20_000, seed++, entry.getKey());
                assertTrue(total < 1 - 1e-3, "some are below the triangle");
            }
        }
    }

    /** The factor is at most 1 and goes to 0 where light grazes the triangle: there the surface behind it begins. */
    @Test
    void theEdgeOfShadowIsSoft() {
        SmoothShading smooth = new SmoothShading(Lambert.INSTANCE);
        Vec3 across = SURFACE.cross(Vec3.X).normalized();
        Vec3 shading = SURFACE.plus(across.times(0.4)).normalized();
        double before = Double.POSITIVE_INFINITY;
        for (int k = 0; k <= 90; k++) {
            double angle = Math.toRadians(k);
            Vec3 light = SURFACE.times(Math.cos(angle)).plus(across.times(Math.sin(angle)));
            Scattering s = to(at(shading, SURFACE), light);
            smooth.evaluate(s);
            double full = 0.5 / Math.PI * shading.dot(light);
            double factor = s.valueG / full;
            assertTrue(factor <= 1 + 1e-15 && factor >= 0 && factor <= before + 1e-12, "at " + k + ": " + factor);
            before = factor;
            if (k == 0) {
                assertEquals(1, factor, 1e-15);
            }
            // The cosine by the surface over that by the normal and the one between the two: 1 − tan·tan or less is 1.
            double g = Math.min(1, SURFACE.dot(light) / (shading.dot(light) * shading.dot(SURFACE)));
            assertEquals(g * g * (1 - g) + g, factor, 1e-12);
        }
        assertTrue(before < 1e-14);
    }

    @Test
    void aNormalThatTurnsAwayFromTheEyeIsMirroredAcrossTheView() {
        SmoothShading smooth = new SmoothShading(Lambert.INSTANCE);
        int turned = 0;
        for (int k = 0; k < 5_000; k++) {
            Vec3 eye = above();
            Vec3 shading = bent(1);
            Vec3 light = above();
            double cosine = shading.dot(eye);
            if (cosine >= 0) {
                continue;
            }
            turned++;
            Vec3 mirrored = shading.minus(eye.times(2 * cosine));
            assertEquals(1, mirrored.length(), 1e-14);
            Scattering s = to(at(shading, eye), light);
            smooth.evaluate(s);
            double value = s.valueG;
            assertEquals(shading, new Vec3(s.nx, s.ny, s.nz), "the normal is put back");
            s = to(at(mirrored, eye), light);
            smooth.evaluate(s);
            assertEquals(s.valueG, value, 1e-12 * value);
            assertTrue(value >= 0);
        }
        assertTrue(turned > 100);
    }
}
