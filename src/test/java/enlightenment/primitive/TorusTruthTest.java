package enlightenment.primitive;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.math.Vec3;
import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** Every crossing of generated lines, compared with a quartic solved in 64 decimal digits (numerics N07, N09, N10). */
class TorusTruthTest {
    private static final double U = 0x1p-53;

    @Test
    void everyCrossingOfGeneratedLinesIsFoundInOrder() {
        compareLines(160, 1);
    }

    @Test
    @Tag("full")
    void everyCrossingOfManyGeneratedLinesIsFoundInOrder() {
        compareLines(60_000, 2);
    }

    private static void compareLines(int count, long seed) {
        Random random = new Random(seed);
        int undecided = 0;
        int[] withCrossings = new int[5];
        for (int i = 0; i < count; i++) {
            Scenario s = Scenario.generate(random);
            TorusTruth truth = s.truth();
            if (truth.clearance() < 16 * U * s.distance()) {
                undecided++;
                continue;
            }
            List<BigDecimal> exact = truth.crossings();
            List<Double> found = crossings(s.torus(), s.origin, s.direction, s.sides);
            assertEquals(exact.size(), found.size(), () -> "crossings of " + s);
            withCrossings[found.size()]++;
            for (int k = 0; k < found.size(); k++) {
                assertEquals(k % 2 == 0 ? Ray.OUTSIDE : Ray.INSIDE, s.sides.get(k), s::toString);
                double off = Math.abs(truth.distanceAt(new BigDecimal(found.get(k))));
                assertTrue(off <= 16 * U * s.distance(), () -> off + " from the surface: " + s);
            }
        }
        assertTrue(undecided < count / 4, undecided + " undecided of " + count);
        int least = Math.min(withCrossings[0], Math.min(withCrossings[2], withCrossings[4]));
        // Each kind has a tenth of the lines or more; of 160, fewer than half of that are two standard deviations away.
        assertTrue(least > count / 20, Arrays.toString(withCrossings));
        assertEquals(0, withCrossings[1] + withCrossings[3]);
    }

    /** All crossings of a line: each search starts just after the crossing found before. */
    private static List<Double> crossings(TorusPrimitive torus, Vec3 o, Vec3 d, List<Integer> sides) {
        Ray ray = Ray.of(o, d);
        ray.tMin = -Double.MAX_VALUE;
        List<Double> found = new ArrayList<>();
        sides.clear();
        for (double t = torus.nearest(ray, Double.MAX_VALUE);
                t != Primitive.MISS;
                t = torus.nearest(ray, Double.MAX_VALUE)) {
            assertTrue(found.size() < 4, "a fifth crossing");
            found.add(t);
            sides.add(torus.side(ray, t));
            ray.tMin = Math.nextUp(t);
        }
        return found;
    }

    @Test
    void crossingsPairEvenWhereTheLineGrazes() {
        pairCrossings(25_000);
    }

    @Test
    @Tag("full")
    void crossingsPairEvenWhereManyLinesGraze() {
        pairCrossings(50_000);
    }

    private static void pairCrossings(int lines) {
        Random random = new Random(3);
        int tooShort = 0;
        int crossings = 0;
        for (int i = 0; i < lines; i++) {
            Scenario s = Scenario.generate(random);
            List<Double> found = crossings(s.torus(), s.origin, s.direction, s.sides);
            crossings += found.size();
            if (found.size() % 2 == 0) {
                for (int k = 0; k < found.size(); k++) {
                    assertEquals(k % 2 == 0 ? Ray.OUTSIDE : Ray.INSIDE, s.sides.get(k), s::toString);
                }
            } else {
                // Both crossings of a chord may round to the same t; the walk along the line then steps over one.
                assertTrue(shortestChord(s) <= 4 * Math.ulp(found.get(0)), () -> found.size() + " crossings of " + s);
                tooShort++;
            }
        }
        assertTrue(tooShort < lines / 100, tooShort + " chords collapsed");
        assertTrue(crossings > lines / 2, crossings + " crossings");
    }

    /** The smallest parameter difference of neighbouring crossings; 0 if the line almost touches the surface. */
    private static double shortestChord(Scenario s) {
        TorusTruth truth = s.truth();
        if (truth.clearance() < 16 * U * s.distance()) {
            return 0;
        }
        List<BigDecimal> exact = truth.crossings();
        double least = Double.POSITIVE_INFINITY;
        for (int k = 1; k < exact.size(); k++) {
            least = Math.min(least, exact.get(k).subtract(exact.get(k - 1)).doubleValue());
        }
        return least;
    }

    @Test
    void aGrazingLadderIsDecidedByTheSignOfTheClearance() {
        climbGrazingLadder(6);
    }

    @Test
    @Tag("full")
    void aGrazingLadderOfManyToriIsDecidedByTheSignOfTheClearance() {
        climbGrazingLadder(12);
    }

    private static void climbGrazingLadder(int tori) {
        Random random = new Random(4);
        int decided = 0;
        for (int i = 0; i < tori; i++) {
            Scenario s = new Scenario(random, random.nextDouble(), 10);
            TorusPrimitive torus = s.torus();
            for (int k = 1; k <= 14; k++) {
                for (int sign = -1; sign <= 1; sign += 2) {
                    s.grazeOuterTube(random, sign * s.minor * Math.pow(10, -k));
                    TorusTruth truth = s.truth();
                    if (truth.clearance() > 4 * U * s.distance()) {
                        decided++;
                        boolean expected = !truth.crossings().isEmpty();
                        assertEquals(expected, torus.intersect(Ray.of(s.origin, s.direction), new Hit()), s::toString);
                    }
                }
            }
        }
        assertTrue(decided > 17 * tori, "only " + decided + " decided");
    }

    @Test
    void aFarTorusIsHitAsExactArithmeticSays() {
        hitFromAfar(12);
    }

    @Test
    @Tag("full")
    void aFarTorusIsHitByManyRaysAsExactArithmeticSays() {
        hitFromAfar(30);
    }

    private static void hitFromAfar(int rays) {
        Random random = new Random(5);
        for (double far : new double[] {1e3, 1e6, 1e9, 1e12}) {
            int decided = 0;
            for (int i = 0; i < rays; i++) {
                Scenario s = new Scenario(random, random.nextDouble(), far);
                s.aim(random, 1);
                TorusTruth truth = s.truth();
                if (truth.clearance() <= 4 * U * s.distance()) {
                    continue;
                }
                decided++;
                List<BigDecimal> exact = truth.crossings();
                double t = s.torus().nearest(Ray.of(s.origin, s.direction), Double.MAX_VALUE);
                assertEquals(exact.isEmpty(), t == Primitive.MISS, s::toString);
                if (t != Primitive.MISS) {
                    assertEquals(exact.get(0).doubleValue(), t, 1e-13 * t / s.cosineAt(t), s::toString);
                }
            }
            assertTrue(decided > rays * 2 / 3, "only " + decided + " decided at " + far);
        }
    }

    @Test
    void pointsAreContainedWhereTheyAreInsideTheTube() {
        contain(1000);
    }

    @Test
    @Tag("full")
    void manyPointsAreContainedWhereTheyAreInsideTheTube() {
        contain(3000);
    }

    private static void contain(int points) {
        Random random = new Random(6);
        int inside = 0;
        for (int i = 0; i < points; i++) {
            Scenario s = new Scenario(random, random.nextDouble(), 1);
            Vec3 p = s.nearRing(random, 1.5 * s.minor);
            double distance = new TorusTruth(s.center, s.axis, s.major, s.minor, p, s.axis).distanceAt(BigDecimal.ZERO);
            if (Math.abs(distance) > 16 * U * s.distance()) {
                assertEquals(distance < 0, s.torus().contains(p.x(), p.y(), p.z()), s::toString);
                inside += distance < 0 ? 1 : 0;
            }
        }
        assertTrue(inside > points / 6, inside + " inside");
        assertTrue(inside < points * 29 / 30, inside + " inside");
    }

    /** A torus and a line, of varied proportions. */
    private static final class Scenario {
        final Vec3 center;
        final Vec3 axis;
        final double major;
        final double minor;
        final double far;
        Vec3 origin = Vec3.ZERO;
        Vec3 direction = Vec3.X;
        final List<Integer> sides = new ArrayList<>();

        Scenario(Random random, double thickness, double far) {
            center = gaussian(random);
            axis = gaussian(random);
            major = 0.2 + random.nextDouble();
            minor = major * thickness;
            this.far = far;
        }

        static Scenario generate(Random random) {
            double thickness =
                    switch (random.nextInt(5)) {
                        case 0 -> 1;
                        case 1 -> Math.pow(10, -6 * random.nextDouble());
                        default -> random.nextDouble();
                    };
            Scenario s = new Scenario(random, thickness, Math.pow(10, 3 * random.nextDouble()));
            if (random.nextInt(4) == 0) {
                s.grazeOuterTube(random, s.minor * Math.pow(10, -12 * random.nextDouble()) * (random.nextInt(3) - 1));
            } else {
                s.aim(random, random.nextInt(3) == 0 ? 1 : 0.3);
            }
            return s;
        }

        /** A line through two points near the ring, or through one and from far away. */
        void aim(Random random, double spread) {
            Vec3 a = nearRing(random, spread * minor);
            Vec3 b = nearRing(random, spread * minor);
            Vec3 d = random.nextBoolean() ? b.minus(a) : gaussian(random);
            from(a, d.normalized());
        }

        /** A line that passes the surface at the given distance, tangential to the tube. */
        void grazeOuterTube(Random random, double clearance) {
            Vec3 a = axis.normalized();
            Vec3 radial = a.cross(gaussian(random)).normalized();
            Vec3 along = a.cross(radial);
            double angle = 2 * Math.PI * random.nextDouble();
            Vec3 n = radial.times(Math.cos(angle)).plus(a.times(Math.sin(angle)));
            Vec3 across = n.cross(along);
            double turn = 2 * Math.PI * random.nextDouble();
            Vec3 p = center.plus(radial.times(major)).plus(n.times(minor + clearance));
            from(p, across.times(Math.cos(turn)).plus(along.times(Math.sin(turn))));
        }

        Vec3 nearRing(Random random, double spread) {
            Vec3 a = axis.normalized();
            Vec3 radial = a.cross(gaussian(random)).normalized();
            return center.plus(radial.times(major)).plus(gaussian(random).times(spread));
        }

        private void from(Vec3 through, Vec3 unit) {
            origin = through.minus(unit.times(far * major));
            direction = through.minus(origin);
        }

        TorusPrimitive torus() {
            return new TorusPrimitive(center, axis.normalized(), major, minor);
        }

        TorusTruth truth() {
            return new TorusTruth(center, axis, major, minor, origin, direction);
        }

        double distance() {
            return origin.minus(center).length() + center.maxAbs() + major + minor;
        }

        double cosineAt(double t) {
            Hit hit = new Hit();
            torus().complete(Ray.of(origin, direction), t, hit);
            return Math.abs(hit.normal().dot(direction.normalized()));
        }

        @Override
        public String toString() {
            return "torus at " + center + " about " + axis + ", radii " + major + ", " + minor + ", from " + origin
                    + " along " + direction;
        }
    }

    private static Vec3 gaussian(Random random) {
        return new Vec3(random.nextGaussian(), random.nextGaussian(), random.nextGaussian());
    }
}
