package enlightenment.bsdf;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import com.tngtech.archunit.core.importer.ImportOption;
import enlightenment.color.Rgb;
import enlightenment.math.Vec3;
import enlightenment.sampling.DirectionChiSquare;
import enlightenment.sampling.SphereCells;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** Samples, densities and values of all surfaces with an extent belong together. */
class BsdfSamplingTest {
    private static final Fresnel GOLD = Fresnel.conductor(new Rgb(0.14, 0.37, 1.44), new Rgb(3.98, 2.38, 1.6));

    /** A kind of surface at which somebody looks. */
    private record Case(String name, Bsdf bsdf, double alpha, double eta) {
        Place seen(double cosine) {
            return Place.seen(bsdf, cosine).color(0.9, 0.5, 0.2).eta(eta);
        }
    }

    private static List<Case> cases() {
        List<Case> all = new ArrayList<>();
        all.add(new Case("Lambert", Lambert.INSTANCE, 1, 1));
        for (double r : new double[] {0, 0.5, 1}) {
            all.add(new Case("rough diffuse " + r, new RoughDiffuse(r), 1, 1));
        }
        all.add(new Case("smooth coat", new SmoothCoating(1.5, false), 1, 1));
        all.add(new Case("smooth coat, nonlinear", new SmoothCoating(2.4, true), 1, 1));
        for (double alpha : new double[] {0.01, 0.1, 0.36, 1}) {
            all.add(new Case("rough coat " + alpha, new RoughCoating(alpha, 1.5, alpha < 0.1), alpha, 1));
            all.add(new Case("glossy " + alpha, new GlossyReflection(alpha, Fresnel.SCHLICK, false), alpha, 1));
            all.add(new Case("compensated " + alpha, new GlossyReflection(alpha, GOLD, true), alpha, 1));
            all.add(new Case("into glass " + alpha, new RoughDielectric(alpha, false), alpha, 1 / 1.5));
            all.add(new Case("out of glass " + alpha, new RoughDielectric(alpha, false), alpha, 1.5));
            Bsdf frosted = new RoughDielectric(alpha, true);
            all.add(new Case("into compensated glass " + alpha, frosted, alpha, 1 / 1.52));
            all.add(new Case("out of compensated glass " + alpha, frosted, alpha, 1.52));
        }
        all.add(new Case("principled", new PrincipledReflection(0.5, 0.36, 1.5, 0, 0, 1.5), 0.36, 1));
        all.add(new Case("coated principled", new PrincipledReflection(0.25, 1, 1.8, 0.7, 0.25, 1.5), 0.25, 1));
        all.add(new Case("varnished principled", new PrincipledReflection(0.5, 0.5, 1.5, 1, 0, 1.5), 0.5, 1));
        all.add(new Case("smooth principled", new PrincipledReflection(0.5, 0, 1.5, 0.5, 0, 1.5), 1, 1));
        all.add(new Case("mirror under haze", new PrincipledReflection(1, 0, 1.5, 0.8, 0.36, 1.5), 0.36, 1));
        all.add(new Case("metal under haze", new PrincipledReflection(1, 0.36, 1.5, 1, 0.5, 1.5), 0.36, 1));
        all.add(new Case("velvet", sheen(0, 1, 0, 1, 0.5), 1, 1));
        all.add(new Case("satin", sheen(0.25, 0.36, 0.5, 0.75, 1), 0.36, 1));
        all.add(new Case("smooth velvet", sheen(0, 0, 0, 1, 0), 1, 1));
        return all;
    }

    private static Bsdf sheen(double metallic, double alpha, double clearcoat, double share, double tint) {
        return new PrincipledReflection(metallic, alpha, 1.5, clearcoat, 0.5, 1.5, share, tint, new PrincipledLayers());
    }

    /** The test with cells around the normal, and for narrow lobes with fine ones around the directions of smooth surfaces. */
    private static void checkDistributions(int rings, int samples, double... cosines) {
        long seed = 1;
        for (Case c : cases()) {
            for (double cosine : cosines) {
                Place place = c.seen(cosine);
                if (c.bsdf instanceof RoughCoating && c.alpha <= 0.1) {
                    // Most samples are of the narrow lobe.
                    place.color(0.01, 0.01, 0.01);
                }
                String what = c.name + " from " + cosine;
                if (c.alpha > 0.1) {
                    SphereCells cells = new SphereCells(place.normal(), 1, rings, 2 * rings);
                    // Beside a delta lobe few samples are left along the surface.
                    int enough = c.bsdf.hasDelta() ? 4 * samples : samples;
                    DirectionChiSquare.check(place, cells, enough, seed++, what);
                } else {
                    SphereCells cells = new SphereCells(place.mirrored(), 4, rings, rings);
                    DirectionChiSquare.check(
                            place.only(false), cells, 3 * samples, seed++, what + " around the mirror image");
                    if (c.bsdf.transmits() && place.s.refract()) {
                        cells = new SphereCells(place.i(), 4, rings, rings);
                        DirectionChiSquare.check(
                                place.only(true), cells, 3 * samples, seed++, what + " around the refracted one");
                    }
                }
            }
        }
    }

    @Test
    void directionsAreDistributedAsTheDensitySays() {
        checkDistributions(24, 20_000, 0.7, 0.05);
    }

    @Test
    @Tag("full")
    void aMillionDirectionsAreDistributedAsTheDensitySays() {
        checkDistributions(80, 1_000_000, 1, 0.7, 0.3, 0.05);
    }

    @Test
    void theTestFindsARoughnessThatIsOffByATenth() {
        Place place = Place.seen(new GlossyReflection(0.36, Fresnel.SCHLICK, false), 0.7);
        Place other = Place.seen(new GlossyReflection(0.4, Fresnel.SCHLICK, false), 0.7);
        DirectionChiSquare.Sampled wrong = new DirectionChiSquare.Sampled() {
            @Override
            public boolean sample(double u, double v, double choice, double[] out) {
                return place.sample(u, v, choice, out);
            }

            @Override
            public double pdf(double x, double y, double z) {
                return other.pdf(x, y, z);
            }
        };
        SphereCells cells = new SphereCells(place.normal(), 1, 24, 48);
        boolean found = false;
        try {
            DirectionChiSquare.check(wrong, cells, 20_000, 1, "wrong");
        } catch (AssertionError e) {
            found = true;
        }
        assertTrue(found);
    }

    @Test
    void aSamplesDensityIsThatOfItsDirectionAndItsWeightIsValueOverDensity() {
        SplittableRandom random = new SplittableRandom(3);
        for (Case c : cases()) {
            int deltas = 0;
            for (double cosine : new double[] {1, 0.7, 0.3, 0.05, 1e-3, 1e-6}) {
                Place place = c.seen(cosine);
                Scattering s = place.s;
                for (int k = 0; k < 400; k++) {
                    s.radiance = k % 2 == 0;
                    if (!c.bsdf.sample(s, random.nextDouble(), random.nextDouble(), random.nextDouble())) {
                        continue;
                    }
                    String what = c.name + " from " + cosine + " sample " + k;
                    if (s.delta) {
                        assertTrue(c.bsdf.hasDelta(), what);
                        assertEquals(0, place.i().minus(place.mirrored()).length(), 4 * Math.ulp(1.0), what);
                        deltas++;
                        continue;
                    }
                    assertEquals(s.transmitted, place.i().dot(place.normal()) < 0, what);
                    assertEquals(1, place.i().length(), 4 * Math.ulp(1.0), what);
                    double pdf = s.pdf;
                    double[] weighed = {s.valueR * pdf, s.valueG * pdf, s.valueB * pdf};
                    assertEquals(pdf, c.bsdf.pdf(s), 1e-9 * pdf, what);
                    c.bsdf.evaluate(s);
                    assertEquals(pdf, s.pdf, 1e-9 * pdf, what);
                    assertEquals(s.valueR, weighed[0], 1e-9 * s.valueR, what);
                    assertEquals(s.valueG, weighed[1], 1e-9 * s.valueG, what);
                    assertEquals(s.valueB, weighed[2], 1e-9 * s.valueB, what);
                }
            }
            assertEquals(c.bsdf.hasDelta(), deltas > 0, c.name);
        }
    }

    /** Those without an extent, and phase functions, have tests of their own. */
    @Test
    void everyKindOfSurfaceIsAmongTheCases() {
        Set<String> tested =
                cases().stream().map(c -> c.bsdf.getClass().getName()).collect(Collectors.toCollection(TreeSet::new));
        tested.add(HenyeyGreenstein.class.getName());
        tested.add(SmoothShading.class.getName());
        Set<String> all = new ClassFileImporter()
                        .withImportOption(ImportOption.Predefined.DO_NOT_INCLUDE_TESTS)
                        .importPackages(Bsdf.class.getPackageName())
                        .stream()
                        .filter(c -> c.isAssignableTo(Bsdf.class) && !c.isInterface())
                        .filter(c -> !c.isAssignableTo(DeltaBsdf.class))
                        .map(JavaClass::getName)
                        .collect(Collectors.toCollection(TreeSet::new));
        assertEquals(all, tested);
        assertTrue(all.size() > 5);
    }

    @Test
    void theValueIsReciprocal() {
        SplittableRandom random = new SplittableRandom(4);
        for (Case c : cases()) {
            int through = 0;
            for (int k = 0; k < 2_000; k++) {
                Place place = c.seen(1);
                place.from(random.nextDouble(), 7 * random.nextDouble());
                double cosine = c.bsdf.transmits() ? 2 * random.nextDouble() - 1 : random.nextDouble();
                place.to(cosine, 7 * random.nextDouble());
                double there = place.f();
                // Importance grows by the squared index on i's side, on the way back by that on o's.
                double squares = cosine < 0 ? place.s.eta * place.s.eta : 1;
                through += cosine < 0 && there > 0 ? 1 : 0;
                place.exchange();
                double back = place.f();
                String what = c.name + " cosine " + cosine;
                // The roundings of unit vectors, seen through a lobe as narrow as alpha.
                assertEquals(there * squares, back, (1e-12 + 1e-14 / (c.alpha * c.alpha)) * back, what);
                place.exchange();
                place.s.radiance = true;
                assertEquals(there * squares, place.f(), 1e-12 * back, what + ": of radiance by that on o's side");
            }
            assertEquals(c.bsdf.transmits(), through > 100, c.name);
        }
    }

    @Test
    void opaqueSurfacesLetNothingThrough() {
        for (Case c : cases()) {
            Place place = c.seen(0.6).to(-0.3, 1);
            c.bsdf.evaluate(place.s);
            if (!c.bsdf.transmits()) {
                assertEquals(0, place.s.valueR + place.s.valueG + place.s.valueB + place.s.pdf);
                assertEquals(0, c.bsdf.pdf(place.s));
            }
            assertFalse(c.bsdf.isDelta());
        }
    }

    @Test
    void noDirectionIsTooExtreme() {
        List<Case> all = new ArrayList<>(cases());
        all.add(new Case("thinnest coat", new SmoothCoating(Math.nextUp(1.0), true), 1, 1));
        all.add(new Case("densest coat", new SmoothCoating(10, true), 1, 1));
        all.add(new Case("least rough coat", new RoughCoating(1e-4, 1 + 1e-9, false), 1e-4, 1));
        all.add(new Case("densest rough coat", new RoughCoating(1, 10, true), 1, 1));
        all.add(new Case("least principled", new PrincipledReflection(0.5, 1e-4, 10, 1, 1e-4, 10), 1e-4, 1));
        all.add(new Case("bare principled", new PrincipledReflection(0, 1, 1, 0, 1, 1.5), 1, 1));
        all.add(new Case("hardly coated", new PrincipledReflection(1, 1, 1, 1e-300, 0, 1.5), 1, 1));
        all.add(new Case("densest principled", new PrincipledReflection(1e-300, 0, 10, 1, 1, 10), 1, 1));
        all.add(new Case("least glossy", new GlossyReflection(1e-4, Fresnel.SCHLICK, true), 1e-4, 1));
        all.add(new Case("least metal", new GlossyReflection(1e-4, GOLD, false), 1e-4, 1));
        all.add(new Case("least glass", new RoughDielectric(1e-4, true), 1e-4, 1.5));
        all.add(new Case("hardly glass", new RoughDielectric(1e-4, true), 1e-4, 1 + 1e-9));
        all.add(new Case("next to no glass", new RoughDielectric(1, true), 1, 1 + 1e-12));
        all.add(new Case("from next to no glass", new RoughDielectric(0.5, true), 0.5, 1 - 1e-12));
        all.add(new Case("no glass", new RoughDielectric(0.1, true), 0.1, 1));
        all.add(new Case("diamond", new RoughDielectric(1, true), 1, 1 / 2.4));
        all.add(new Case("dense", new RoughDielectric(0.01, true), 0.01, 1e3));
        all.add(new Case("endlessly dense", new RoughDielectric(0.5, true), 0.5, 1e-300));
        double[] cosines = {1, 0.5, 1e-3, 1e-10, 1e-154, 1e-300, Double.MIN_VALUE, 0, -1e-17};
        double[] numbers = {0, Double.MIN_VALUE, 0.25, 0.5, Math.nextDown(1.0), 0.123};
        double[] colors = {0, 1e-300, 0.5, 1};
        for (Case c : all) {
            for (int axis = 0; axis < 6; axis++) {
                for (double cosine : cosines) {
                    for (double color : colors) {
                        checkExtreme(c, axis, cosine, color, numbers);
                    }
                }
            }
        }
    }

    private static void checkExtreme(Case c, int axis, double cosine, double color, double[] numbers) {
        Scattering s = new Scattering();
        s.red = color;
        s.green = color;
        s.blue = color;
        s.eta = c.eta;
        double sign = axis < 3 ? 1 : -1;
        double sine = Math.sqrt(1 - cosine * cosine);
        Vec3 n = List.of(Vec3.X, Vec3.Y, Vec3.Z).get(axis % 3).times(sign);
        Vec3 across = List.of(Vec3.Y, Vec3.Z, Vec3.X).get(axis % 3);
        s.nx = n.x();
        s.ny = n.y();
        s.nz = n.z();
        Vec3 o = n.times(cosine).plus(across.times(sine));
        s.ox = o.x();
        s.oy = o.y();
        s.oz = o.z();
        for (double u : numbers) {
            for (double choice : numbers) {
                if (c.bsdf.sample(s, u, 1 - u, choice)) {
                    checkNumbers(c, s, cosine);
                    assertTrue(s.pdf > 0);
                }
                for (Vec3 i : List.of(o, o.negated(), n, n.negated(), across, across.negated(), mirror(o, n))) {
                    s.ix = i.x();
                    s.iy = i.y();
                    s.iz = i.z();
                    c.bsdf.evaluate(s);
                    checkNumbers(c, s, cosine);
                    assertEquals(s.pdf, c.bsdf.pdf(s), 1e-9 * s.pdf);
                }
            }
        }
    }

    private static Vec3 mirror(Vec3 o, Vec3 n) {
        return n.times(2 * o.dot(n)).minus(o);
    }

    private static void checkNumbers(Case c, Scattering s, double cosine) {
        double sum = s.valueR + s.valueG + s.valueB + s.pdf;
        boolean right = sum >= 0 && sum < Double.POSITIVE_INFINITY && Math.abs(s.ix) <= 1 && Math.abs(s.iy) <= 1;
        assertTrue(right && Math.abs(s.iz) <= 1, () -> c.name + " from " + cosine + ": " + s.valueR + " " + s.pdf);
    }

    private static double bound(Case c) {
        if (c.bsdf instanceof RoughDiffuse) {
            return 3.6;
        }
        if (c.bsdf instanceof RoughCoating || c.bsdf instanceof PrincipledReflection) {
            // One over the least share of the coat's own reflection, along the surface.
            return 10;
        }
        return c.name.contains("comp") || c.bsdf.hasDelta() ? 2.5 : 1 + 1e-12;
    }

    @Test
    void weightsAreBounded() {
        SplittableRandom random = new SplittableRandom(6);
        for (Case c : cases()) {
            double bound = bound(c);
            for (double cosine : new double[] {1, 0.7, 0.3, 0.05, 1e-3, 1e-6}) {
                Place place = c.seen(cosine).color(1, 1, 1);
                for (int k = 0; k < 2_000; k++) {
                    if (c.bsdf.sample(place.s, random.nextDouble(), random.nextDouble(), random.nextDouble())) {
                        assertTrue(place.s.valueR <= bound, c.name + " from " + cosine + ": " + place.s.valueR);
                    }
                }
            }
        }
    }
}
