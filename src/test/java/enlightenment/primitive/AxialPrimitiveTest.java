package enlightenment.primitive;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.frame.SceneFrame;
import enlightenment.geometry.Cone;
import enlightenment.geometry.Cylinder;
import enlightenment.geometry.Disk;
import enlightenment.geometry.Sphere;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class AxialPrimitiveTest {
    private static final Vec3 DOWN = new Vec3(0, -1, 0);

    private final Primitive cone = new ConePrimitive(Vec3.ZERO, Vec3.Y, 0.5, 0, true);
    private final Primitive column = new CylinderPrimitive(new Vec3(0, -1, 0), new Vec3(0, 1, 0), 0.5, true);
    private final Primitive pipe = new CylinderPrimitive(new Vec3(0, -1, 0), new Vec3(0, 1, 0), 0.5, false);

    private static Hit hit(Primitive p, Ray ray) {
        Hit hit = new Hit();
        assertTrue(p.intersect(ray, hit));
        return hit;
    }

    @Test
    void theMirrorNappeOfAConeIsNeverHit() {
        Hit slope = hit(cone, Ray.of(new Vec3(0.1, 5, 0), DOWN));
        assertEquals(4.2, slope.t, 1e-14);
        assertEquals(AxialPrimitive.LATERAL, slope.face);
        assertEquals(4, hit(cone, Ray.of(new Vec3(0, 5, 0), DOWN)).t, 1e-14);
        Hit base = hit(cone, Ray.of(new Vec3(0.1, -5, 0), Vec3.Y));
        assertEquals(5, base.t, 1e-14);
        assertEquals(AxialPrimitive.BASE, base.face);
        // Through the mirror nappe and beside the cone; within the mirror nappe only.
        assertEquals(Primitive.MISS, cone.nearest(Ray.of(new Vec3(-1, 2, 0), Vec3.X), Double.MAX_VALUE));
        assertEquals(Primitive.MISS, cone.nearest(Ray.of(new Vec3(0, 2, 0), new Vec3(1, 0.1, 0)), Double.MAX_VALUE));
    }

    @Test
    void aRayAlongAGeneratorsDirectionMeetsTheConeOnce() {
        // The generator in the x-y plane on the +x side runs along (1, -2, 0).
        Vec3 along = new Vec3(1, -2, 0);
        Hit base = hit(cone, Ray.of(new Vec3(0.25, -1, 0), along.negated()));
        assertEquals(0.5, base.t, 1e-14);
        assertEquals(AxialPrimitive.BASE, base.face);
        Hit slope = hit(cone, Ray.of(new Vec3(-1, 2, 0), along));
        // x = -(1 - y)/2 at x = -1 + t, y = 2 - 2t: t = 3/4.
        assertEquals(0.75, slope.t, 1e-14);
        assertEquals(AxialPrimitive.LATERAL, slope.face);
        assertEquals(Primitive.MISS, cone.nearest(Ray.of(new Vec3(0.5, 1, 0), along), Double.MAX_VALUE));
    }

    /** Beside the distance, length and radius of the solid are below the smallest double: it must not lose its axis. */
    @Test
    void aRayFromBeyondTheRangeOfDoublesPassesATinySolid() {
        double tiny = 0x1p-740;
        double far = 0x1p400;
        for (Primitive p : List.of(
                Primitives.place(
                        new Cone(ExactPoint.ORIGIN, ExactPoint.of(0, tiny, 0), tiny, 0, true), SceneFrame.WORLD),
                Primitives.place(
                        new Cylinder(ExactPoint.ORIGIN, ExactPoint.of(0, tiny, 0), tiny, true), SceneFrame.WORLD))) {
            Hit hit = new Hit();
            assertFalse(p.intersect(Ray.of(new Vec3(0, 0, far), new Vec3(0, 0.25, -1)), hit), p + " is beside the ray");
            assertFalse(p.intersect(Ray.of(new Vec3(0, 0, far), new Vec3(0, 0, 1)), hit), p + " is behind the ray");
        }
    }

    @Test
    void normalsAreFiniteUpToTheApex() {
        int hits = 0;
        for (double off : new double[] {0, Double.MIN_VALUE, 1e-300, 1e-18, 1e-9, 1e-3}) {
            for (Vec3 d : List.of(DOWN, new Vec3(0.1, -1, 0.2), new Vec3(-1, -0.5, 0), new Vec3(3, -1e-9, 1))) {
                Vec3 o = new Vec3(off, 1, 0).minus(d.times(2));
                Hit hit = new Hit();
                if (cone.intersect(Ray.of(o, d), hit)) {
                    hits++;
                    assertEquals(1, hit.normal().length(), 0x1p-50, () -> "aimed " + off + " beside the apex");
                }
            }
        }
        assertTrue(hits >= 12, hits + " of 24 rays meet the cone");
        // The slope's normal: across the generator (1, -2, 0) in the plane of the axis.
        Hit near = hit(cone, Ray.of(new Vec3(1, 1 - 1e-9, 0), new Vec3(-1, 0, 0)));
        assertEquals(2 / Math.sqrt(5), near.nx, 1e-15);
        assertEquals(1 / Math.sqrt(5), near.ny, 1e-15);
        assertEquals(0, near.nz, 1e-15);
    }

    @Test
    void aColumnIsEnteredAndLeftThroughTheFaceInFront() {
        Hit side = hit(column, Ray.of(new Vec3(2, 0.25, 0), new Vec3(-1, 0, 0)));
        assertEquals(1.5, side.t);
        assertEquals(new Vec3(0.5, 0.25, 0), side.point());
        assertEquals(AxialPrimitive.LATERAL, side.face);
        assertEquals(Ray.OUTSIDE, side.side);
        Hit top = hit(column, Ray.of(new Vec3(0.25, 3, 0), DOWN));
        assertEquals(2, top.t);
        assertEquals(new Vec3(0.25, 1, 0), top.point());
        assertEquals(Vec3.Y, top.normal());
        assertEquals(AxialPrimitive.TOP, top.face);
        Hit out = hit(column, Ray.of(new Vec3(0.25, 0, 0), DOWN));
        assertEquals(1, out.t);
        assertEquals(AxialPrimitive.BASE, out.face);
        assertEquals(Ray.INSIDE, out.side);
        assertEquals(0, new Vec3(0, -1, 0).minus(out.normal()).length());
        assertEquals(Primitive.MISS, column.nearest(Ray.of(new Vec3(0.25, 3, 0), DOWN), 1.9));
    }

    @Test
    void anEndsPlaneIsMetAtExactlyTheParameterOfARectangleInIt() {
        RoundSamples s = new RoundSamples(30);
        double y = 0.1;
        Primitive cylinder = new CylinderPrimitive(new Vec3(0, y, 0), new Vec3(0, 1.7, 0), 1, true);
        Primitive disk = new DiskPrimitive(new Vec3(0, y, 0), new Vec3(0, -3, 0), 1);
        Primitive floor =
                new RectanglePrimitive(new Vec3(-9, y, -9), new Vec3(-9, y, 9), new Vec3(9, y, 9), new Vec3(9, y, -9));
        for (int i = 0; i < 1000; i++) {
            Vec3 o = new Vec3(s.uniform(-3, 3), -s.magnitude(1e-3, 1e3), s.uniform(-3, 3));
            Vec3 d = new Vec3(s.uniform(-0.6, 0.6), y, s.uniform(-0.6, 0.6)).minus(o);
            Hit hit = hit(cylinder, Ray.of(o, d));
            Hit expected = hit(floor, Ray.of(o, d));
            assertEquals(AxialPrimitive.BASE, hit.face);
            assertEquals(expected.t, hit.t);
            assertEquals(expected.t, hit(disk, Ray.of(o, d)).t);
            assertEquals(y, hit.py);
            assertEquals(y, hit(disk, Ray.of(o, d)).py);
        }
    }

    @Test
    void aPipeIsOpenAtItsEnds() {
        assertEquals(Primitive.MISS, pipe.nearest(Ray.of(new Vec3(0.25, 3, 0), DOWN), Double.MAX_VALUE));
        Hit wall = hit(pipe, Ray.of(new Vec3(0, 2, 0), new Vec3(0.5, -2, 0)));
        assertEquals(1, wall.t, 1e-15);
        assertEquals(Ray.INSIDE, wall.side);
        Hit far = hit(pipe, Ray.of(Vec3.ZERO, Vec3.X));
        assertEquals(0.5, far.t);
        assertEquals(Ray.INSIDE, far.side);
        assertFalse(pipe.isSolid());
        assertFalse(pipe.contains(0, 0, 0));
        // The lateral surface includes its rims.
        assertEquals(1.5, pipe.nearest(Ray.of(new Vec3(2, 1, 0), new Vec3(-1, 0, 0)), 9));
    }

    @Test
    void aRayThatStartsOnAPipeSeesOnlyItsFarWall() {
        Vec3 wall = new Vec3(0.5, 0, 0);
        Ray across = Ray.leaving(wall, new Vec3(-1, 0.25, 0), pipe, Ray.INSIDE);
        assertEquals(1, pipe.nearest(across, 9), 1e-15);
        Ray throughTheEnd = Ray.leaving(wall, new Vec3(-1, 4, 0), pipe, Ray.INSIDE);
        assertEquals(Primitive.MISS, pipe.nearest(throughTheEnd, 9));
        Ray away = Ray.leaving(wall, new Vec3(1, 0, 0), pipe, Ray.OUTSIDE);
        assertEquals(Primitive.MISS, pipe.nearest(away, 9));
        assertEquals(Primitive.MISS, pipe.nearest(Ray.leaving(wall, DOWN, pipe, Ray.OUTSIDE), 9));
    }

    private static Primitive ofHeight(int kind, Vec3 axis) {
        return switch (kind) {
            case 0 -> new CylinderPrimitive(Vec3.ZERO, axis, 1, true);
            case 1 -> new ConePrimitive(Vec3.ZERO, axis, 1, 0, true);
            case 2 -> new ConePrimitive(Vec3.ZERO, axis, 0.5, 1, true);
            default -> new ConePrimitive(Vec3.ZERO, axis, 1, 1, true);
        };
    }

    @ParameterizedTest
    @ValueSource(doubles = {1e-100, 1e-50, 1e-20, 1e-12, 1e-6, 1e6, 1e12, 1e20, 1e50, 1e100})
    void wafersAndNeedlesAreHitOnTheirSurface(double height) {
        RoundSamples s = new RoundSamples(33);
        int hits = 0;
        for (int i = 0; i < 300; i++) {
            Vec3 axis = s.axis().times(height);
            Primitive p = ofHeight(i % 4, axis);
            double reach = Math.max(1, height);
            boolean aimedAtCenter = s.oneIn(2);
            Vec3 target = aimedAtCenter ? axis.times(0.5) : s.direction().times(s.uniform(0, 1.5));
            Vec3 o = s.direction().times(5 * reach);
            Hit hit = new Hit();
            boolean met = p.intersect(Ray.of(o, target.minus(o)), hit);
            assertTrue(met || !aimedAtCenter || height > 1, "a wafer cannot be missed in the middle");
            if (met) {
                hits++;
                double off = ExactSolid.of(p).distance(hit.point());
                assertTrue(off <= 8 * IntersectionVectorsTest.pointUlp(p, hit.point()), () -> off + " off " + p);
                assertEquals(1, hit.normal().length(), 0x1p-50);
            }
        }
        assertTrue(hits > 20, hits + " hits");
    }

    private static void leaveThroughTheRim(int rays) {
        RoundSamples s = new RoundSamples(31);
        AxialPrimitive p = null;
        int[] faces = new int[3];
        for (int i = 0; i < rays; i++) {
            if (i % 100 == 0) {
                p = (AxialPrimitive) s.primitive(RoundSamples.CONVEX.get(1 + s.below(4)), 1, s.uniform(0, 10));
            }
            Vec3 axis = p.top().minus(p.base());
            int end = s.below(2);
            double r = end == 0 ? p.baseRadius() : p.topRadius();
            double off = (s.oneIn(2) ? 1 : -1) * s.magnitude(1e-16, 1e-3);
            Vec3 rim = p.base()
                    .plus(axis.times(end))
                    .plus(s.across(axis.normalized()).times(r));
            double f = s.uniform(0.1, 0.9);
            double local = p.baseRadius() + f * (p.topRadius() - p.baseRadius());
            Vec3 o = p.base()
                    .plus(axis.times(f))
                    .plus(s.across(axis.normalized()).times(s.uniform(0, 0.5) * local));
            Hit hit = hit(p, Ray.of(o, rim.plus(s.direction().times(off)).minus(o)));
            assertEquals(Ray.INSIDE, hit.side);
            // A ball around the start is inside; by convexity it and the rim bound how early and how late it leaves.
            double slant = new Vec3(axis.length(), p.baseRadius() - p.topRadius(), 0).length();
            double clear = Math.min(0.5 * local * axis.length() / slant, 0.1 * axis.length());
            double early = Math.abs(off) / clear;
            assertTrue(hit.t >= (1 - 1e-12) / (1 + early), () -> "leaves early");
            assertTrue(early >= 1 || hit.t <= (1 + 1e-12) / (1 - early), () -> "leaves late");
            faces[hit.face]++;
        }
        assertTrue(faces[0] > rays / 20 && faces[1] > rays / 20 && faces[2] > rays / 20);
    }

    @Test
    void everyRayTowardsARimLeavesThroughExactlyOneFace() {
        leaveThroughTheRim(100_000);
    }

    @Tag("full")
    @Test
    void everyOneOfAMillionRaysTowardsARimLeavesThroughExactlyOneFace() {
        leaveThroughTheRim(1_000_000);
    }

    @ParameterizedTest
    @ValueSource(strings = {"sphere", "cylinder", "cone", "frustum", "flare"})
    void boundsHoldEveryHitAndContainsAgreesWithTheCrossings(String kind) {
        RoundSamples s = new RoundSamples(32);
        int inside = 0;
        int decided = 0;
        for (int i = 0; i < 4000; i++) {
            Primitive p = s.primitive(kind, s.magnitude(1e-6, 1e6), s.magnitude(1e-6, 1e6));
            double size = RoundSamples.size(p);
            assertTrue(p.bounds().contains(s.surfacePoint(p).point()), () -> kind + " sticks out");
            Vec3 o = RoundSamples.center(p).plus(s.direction().times(size * s.uniform(0, 0.8)));
            Vec3 d = s.direction();
            Hit hit = new Hit();
            boolean met = p.intersect(Ray.of(o, d), hit);
            boolean contained = p.contains(o.x(), o.y(), o.z());
            boolean agrees = contained == (met && hit.side == Ray.INSIDE);
            // The decimal distance is dear: it is needed where they disagree, and to see that few starts are at the
            // surface.
            if (!agrees || i % 10 == 0) {
                boolean clear = ExactSolid.of(p).distance(o) > 1e-9 * (size + o.maxAbs());
                assertTrue(
                        agrees || !clear,
                        () -> "contained: " + contained + ", by crossings otherwise: " + o + " in " + p);
                decided += clear ? 1 : 0;
            }
            inside += contained ? 1 : 0;
        }
        assertTrue(decided > 300, decided + " of 400 decided");
        assertTrue(inside > 500 && inside < 3500, inside + " inside");
    }

    @Test
    void boundsAreTight() {
        assertArrayEquals(
                new double[] {-0.5, -1, -0.5}, components(column.bounds().min()), 1e-15);
        assertArrayEquals(new double[] {0.5, 1, 0.5}, components(column.bounds().max()), 1e-15);
        assertArrayEquals(new double[] {0.5, 1, 0.5}, components(cone.bounds().max()), 1e-15);
        // A disk across (3, 4, 0)/5 reaches 4/5 of its radius along x and 3/5 along y.
        Primitive disk = new DiskPrimitive(Vec3.ZERO, new Vec3(3, 4, 0), 10);
        assertArrayEquals(new double[] {8, 6, 10}, components(disk.bounds().max()), 1e-13);
    }

    private static double[] components(Vec3 v) {
        return new double[] {v.x(), v.y(), v.z()};
    }

    private static void assertTexture(double u, double v, Primitive p, Vec3 from, Vec3 towards) {
        Hit hit = hit(p, Ray.of(from, towards.minus(from)));
        p.textureCoordinates(hit);
        assertEquals(u, hit.u, 1e-15, "u");
        assertEquals(v, hit.v, 1e-15, "v");
    }

    @Test
    void aColumnsTextureGrowsToTheRightAndDownwardsFromItsSeamAtTheFront() {
        for (Primitive p : List.of(column, pipe)) {
            assertTexture(0.25, 0.5, p, new Vec3(2, 0, 0), Vec3.ZERO);
            assertTexture(0.5, 0.25, p, new Vec3(0, 0.5, 2), new Vec3(0, 0.5, 0));
            assertTexture(0.75, 0.75, p, new Vec3(-2, -0.5, 0), new Vec3(0, -0.5, 0));
            assertTexture(0, 0.5, p, new Vec3(0, 0, -2), Vec3.ZERO);
        }
        // Upside down, the viewer's right is the texture's left.
        Primitive turned = new CylinderPrimitive(new Vec3(0, 1, 0), new Vec3(0, -1, 0), 0.5, true);
        assertTexture(0.75, 0.25, turned, new Vec3(2, -0.5, 0), new Vec3(0, -0.5, 0));
    }

    @Test
    void aConesTextureIsThatOfTheColumnAroundIt() {
        assertTexture(0.25, 0.5, cone, new Vec3(2, 0.5, 0), new Vec3(0, 0.5, 0));
        Primitive flare = new ConePrimitive(Vec3.ZERO, Vec3.Y, 0.25, 0.5, true);
        assertTexture(0.25, 0.75, flare, new Vec3(2, 0.25, 0), new Vec3(0, 0.25, 0));
        assertTexture(0.75, 0.5, flare, new Vec3(0.25, 3, 0), new Vec3(0.25, 0, 0));
    }

    @Test
    void theEndsShowTheirTextureTheRightWayRoundFromOutside() {
        // From above with +z up, and from below with -z up, +x is to the right.
        assertTexture(0.75, 0.5, column, new Vec3(0.25, 3, 0), new Vec3(0.25, 0, 0));
        assertTexture(0.5, 0.25, column, new Vec3(0, 3, 0.25), new Vec3(0, 0, 0.25));
        assertTexture(0.75, 0.5, column, new Vec3(0.25, -3, 0), new Vec3(0.25, 0, 0));
        assertTexture(0.5, 0.25, column, new Vec3(0, -3, -0.25), new Vec3(0, 0, -0.25));
    }

    @Test
    void aDisksTextureIsUprightAndTheRightWayRound() {
        // The viewer at -z looks along +z and has +x at the right hand.
        Primitive front = new DiskPrimitive(Vec3.ZERO, new Vec3(0, 0, -2), 1);
        assertTexture(0.5, 0.5, front, new Vec3(0, 0, -3), Vec3.ZERO);
        assertTexture(0.75, 0.5, front, new Vec3(0.5, 0, -3), new Vec3(0.5, 0, 0));
        assertTexture(0.5, 0.25, front, new Vec3(0, 0.5, -3), new Vec3(0, 0.5, 0));
        Primitive floor = new DiskPrimitive(Vec3.ZERO, Vec3.Y, 1);
        assertTexture(0.75, 0.5, floor, new Vec3(0.5, 3, 0), new Vec3(0.5, 0, 0));
        assertTexture(0.5, 0.25, floor, new Vec3(0, 3, 0.5), new Vec3(0, 0, 0.5));
    }

    @Test
    void aSpheresTextureHasItsSeamAtTheFrontAndItsTopAtThePole() {
        Primitive ball = Primitives.place(Sphere.of(ExactPoint.ORIGIN, 1), SceneFrame.WORLD);
        assertTexture(0, 0.5, ball, new Vec3(0, 0, -3), Vec3.ZERO);
        assertTexture(0.25, 0.5, ball, new Vec3(3, 0, 0), Vec3.ZERO);
        assertTexture(0.75, 0.5, ball, new Vec3(-3, 0, 0), Vec3.ZERO);
        Hit pole = hit(ball, Ray.of(new Vec3(0, 3, 0), DOWN));
        ball.textureCoordinates(pole);
        assertEquals(0, pole.v);
    }

    @Test
    void aDiskIsSeenFromBothSides() {
        Primitive disk = Primitives.place(new Disk(ExactPoint.ORIGIN, new Vec3(0, 0, -7), 1), SceneFrame.WORLD);
        Hit front = hit(disk, Ray.of(new Vec3(0.5, 0, -3), Vec3.Z));
        assertEquals(Ray.OUTSIDE, front.side);
        assertEquals(0, new Vec3(0, 0, -1).minus(front.normal()).length());
        assertEquals(Ray.INSIDE, hit(disk, Ray.of(new Vec3(0.5, 0, 3), new Vec3(0, 0, -1))).side);
        assertEquals(Primitive.MISS, disk.nearest(Ray.of(new Vec3(-3, 0, 0), Vec3.X), Double.MAX_VALUE));
        assertEquals(Primitive.MISS, disk.nearest(Ray.of(new Vec3(1.0000001, 0, -3), Vec3.Z), Double.MAX_VALUE));
        assertEquals(3, disk.nearest(Ray.of(new Vec3(1, 0, -3), Vec3.Z), Double.MAX_VALUE), "the rim belongs to it");
        assertFalse(disk.contains(0, 0, 0));
    }

    @Test
    void placingRoundShapesMovesThemIntoTheFrame() {
        SceneFrame frame = new SceneFrame(ExactPoint.of(1, 2, 3), 1);
        Primitive p = Primitives.place(new Cone(ExactPoint.of(1, 2, 3), ExactPoint.of(1, 6, 3), 2, 1, false), frame);
        assertArrayEquals(new double[] {0, 0, 0, 0, 2, 0, 1, 0.5, 0, 0, 2, 0}, p.parameters());
        Primitive q = Primitives.place(new Cylinder(ExactPoint.of(1, 2, 3), ExactPoint.of(1, 6, 3), 2, true), frame);
        assertArrayEquals(new double[] {0, 0, 0, 0, 2, 0, 1, 1, 1, 0, 2, 0}, q.parameters());
        assertArrayEquals(
                new double[] {0, 0, 0, 0, 4, 0, 2, 2, 1, 0, 4, 0}, q.scaledBy(1).parameters());
        Primitive disk = Primitives.place(new Disk(ExactPoint.of(3, 2, 3), Vec3.Y, 4), frame);
        assertArrayEquals(new double[] {1, 0, 0, 0, 1, 0, 2}, disk.parameters());
    }
}
