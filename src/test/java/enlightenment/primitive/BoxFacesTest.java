package enlightenment.primitive;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.frame.Rotation;
import enlightenment.math.Vec3;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** N14: a box is closed. Rays in its faces and along its edges meet it; nothing becomes NaN. */
class BoxFacesTest {
    private static final double[] SCALES = {1e-9, 1, 1e9};

    @Test
    void raysInFacesAndEdgesMeetTheBox() {
        raysInFaces(100_000);
    }

    @Test
    @Tag("full")
    void aMillionRaysInFacesAndEdgesMeetTheBox() {
        raysInFaces(1_000_000);
    }

    /** The ray lies in one face, or in two (an edge), with zero components of either sign; the box may have no thickness. */
    private static void raysInFaces(int rays) {
        RandomRays random = new RandomRays(14);
        Hit hit = new Hit();
        for (int i = 0; i < rays; i++) {
            double scale = SCALES[i % 3];
            double[] lo = new double[3];
            double[] hi = new double[3];
            double[] o = new double[3];
            double[] d = new double[3];
            int run = random.index(3);
            int flat = random.index(8);
            for (int k = 0; k < 3; k++) {
                lo[k] = scale * random.signed();
                hi[k] = k == flat && k != run ? lo[k] : lo[k] + scale * (0.1 + random.uniform());
                o[k] = random.index(2) == 0 ? lo[k] : hi[k];
                d[k] = random.index(2) == 0 ? 0.0 : -0.0;
            }
            // It runs along one axis; on one of the others it may lie between the faces instead of in one.
            o[run] = lo[run] - scale * random.uniform();
            d[run] = scale * random.uniform() + 1e-3 * scale;
            int other = (run + 1) % 3;
            if (i % 2 == 0) {
                o[other] = Slabs.clamp(lo[other] + random.uniform() * (hi[other] - lo[other]), lo[other], hi[other]);
            }
            Primitive box = new BoxPrimitive(vector(lo), vector(hi));
            boolean backwards = random.index(2) == 0;
            if (backwards) {
                o[run] = hi[run] + scale * random.uniform();
                d[run] = -d[run];
            }
            Ray ray = Ray.of(vector(o), vector(d));
            assertTrue(box.intersect(ray, hit), "ray " + i);
            double face = backwards ? hi[run] : lo[run];
            assertEquals((face - o[run]) / d[run], hit.t, "ray " + i);
            assertEquals(face, hit.point().component(run), "the face's coordinate is assigned");
            assertEquals(2 * run + (backwards ? 1 : 0), hit.face);
            assertTrue(hit.point().isFinite() && hit.normal().length() == 1);
        }
    }

    private static Vec3 vector(double[] v) {
        return new Vec3(v[0], v[1], v[2]);
    }

    @Test
    void raysInAFaceAtAnAngleMeetTheBox() {
        RandomRays random = new RandomRays(141);
        for (int i = 0; i < 100_000; i++) {
            double top = random.signed();
            Primitive box = new BoxPrimitive(new Vec3(-1, -2, -1), new Vec3(1, top, 1));
            Vec3 from = new Vec3(3 * random.signed(), top, 3 + random.uniform());
            Vec3 to = new Vec3(0.99 * random.signed(), top, 0.99 * random.signed());
            Vec3 d = new Vec3(to.x() - from.x(), random.index(2) == 0 ? 0.0 : -0.0, to.z() - from.z());
            assertTrue(box.nearest(Ray.of(from, d), 1) <= 1, "ray " + i);
            Ray above = Ray.of(new Vec3(from.x(), Math.nextUp(top), from.z()), d);
            assertEquals(Primitive.MISS, box.nearest(above, Double.MAX_VALUE), "ray " + i + " just above");
        }
    }

    @Test
    void raysExactlyThroughAnEdgeMeetTheBox() {
        RandomRays random = new RandomRays(142);
        for (int i = 0; i < 100_000; i++) {
            // Dyadic numbers, so that the ray meets the edge x = 0, y = 0 of the box exactly.
            double x = (1 + random.index(1 << 20)) * 0x1p-18;
            double y = (1 + random.index(1 << 20)) * 0x1p-18;
            double steps = 1 + random.index(6);
            double t = 1 / (2 * steps + 1);
            Primitive box = new BoxPrimitive(Vec3.ZERO, new Vec3(9, 9, 9));
            Vec3 d = new Vec3(-x, y, 0.25).times(2 * steps + 1);
            double found = box.nearest(Ray.of(new Vec3(x, -y, 4), d), Double.MAX_VALUE);
            assertEquals(t, found, 2 * Math.ulp(t), "ray " + i);
        }
    }

    @Test
    void aRayFromInsideLeavesThroughExactlyOneFace() {
        RandomRays random = new RandomRays(143);
        Hit hit = new Hit();
        int[] faces = new int[6];
        for (int i = 0; i < 60_000; i++) {
            boolean turned = i % 2 == 0;
            Primitive p = turned
                    ? new CubePrimitive(random.inCube(), 1, random.rotation())
                    : new BoxPrimitive(new Vec3(-1, -1, -1), new Vec3(1, 1, 1));
            Vec3 center = p.bounds().center();
            Vec3 o = center.plus(random.inCube().times(0.3));
            // Towards an edge or a corner, a little off.
            Vec3 corner = new Vec3(2 * random.index(2) - 1, 2 * random.index(2) - 1, random.index(3) - 1);
            Vec3 d = corner.plus(random.inCube().times(random.decade(-16, 0))).minus(o.minus(center));
            assertTrue(p.intersect(Ray.of(o, d), hit), "ray " + i);
            assertEquals(Ray.INSIDE, hit.side);
            assertTrue(hit.normal().dot(d) > 0, "outwards, ray " + i);
            faces[hit.face]++;
        }
        for (int count : faces) {
            assertTrue(count > 1000, "every face is left through");
        }
    }

    @Test
    void aBoxWithoutThicknessHasTwoSides() {
        Primitive box = new BoxPrimitive(Vec3.ZERO, new Vec3(1, 0, 1));
        Hit hit = new Hit();
        assertTrue(box.intersect(Ray.of(new Vec3(0.5, 2, 0.5), new Vec3(0, -1, 0)), hit));
        assertEquals(2, hit.t);
        assertEquals(3, hit.face);
        assertEquals(Ray.OUTSIDE, hit.side);
        assertTrue(box.intersect(Ray.leaving(hit.point(), new Vec3(0, -1, 0), box, Ray.INSIDE), hit));
        assertEquals(0, hit.t, Double.MIN_VALUE);
        assertEquals(2, hit.face);
        assertEquals(Ray.INSIDE, hit.side);
        box.textureCoordinates(hit);
        assertEquals(0.5, hit.u);
        assertEquals(0.5, hit.v);
    }

    @Test
    void facesAreNumberedInTheOrderOfTheAxes() {
        Vec3[] normals = {Vec3.X.negated(), Vec3.X, Vec3.Y.negated(), Vec3.Y, Vec3.Z.negated(), Vec3.Z};
        Rotation turn = Rotation.ofDegrees(new Vec3(20, 30, 40));
        Hit hit = new Hit();
        for (int k = 0; k < 6; k++) {
            Primitive box = new BoxPrimitive(new Vec3(-1, -1, -1), new Vec3(1, 1, 1));
            assertTrue(box.intersect(Ray.of(normals[k].times(5), normals[k].negated()), hit));
            assertEquals(k, hit.face);
            assertEquals(normals[k].plus(Vec3.ZERO), hit.normal());
            Vec3 turned = turn.apply(normals[k]);
            Primitive cube = new CubePrimitive(Vec3.ZERO, 1, turn);
            assertTrue(cube.intersect(Ray.of(turned.times(5), turned.negated()), hit));
            assertEquals(k, hit.face);
            assertTrue(hit.normal().minus(turned).maxAbs() < 1e-15);
        }
        assertEquals(6, new CubePrimitive(Vec3.ZERO, 1, turn).faceCount());
    }

    @Test
    void aCubeOfQuarterTurnsIsTheBoxThatItLooksLike() {
        RandomRays random = new RandomRays(144);
        Hit ofCube = new Hit();
        Hit ofBox = new Hit();
        int hits = 0;
        for (int i = 0; i < 64_000; i++) {
            Rotation r = Rotation.ofDegrees(new Vec3(90 * (i & 3), 90 * (i >> 2 & 3), 90 * (i >> 4 & 3)));
            Vec3 c = random.inCube();
            Primitive cube = new CubePrimitive(c, 0.7, r);
            Vec3 h = new Vec3(0.7, 0.7, 0.7);
            Primitive box = new BoxPrimitive(c.minus(h), c.plus(h));
            Vec3 o = random.inCube().times(3);
            Vec3 d = c.plus(random.inCube()).minus(o);
            Ray ray = Ray.of(o, i % 3 == 0 ? new Vec3(d.x(), 0.0, -0.0) : d);
            boolean met = box.intersect(ray, ofBox);
            assertEquals(met, cube.intersect(ray, ofCube));
            assertEquals(box.contains(o.x(), o.y(), o.z()), cube.contains(o.x(), o.y(), o.z()));
            if (met) {
                hits++;
                assertEquals(ofBox.t, ofCube.t);
                assertEquals(ofBox.point(), ofCube.point());
                assertEquals(ofBox.normal(), ofCube.normal());
                Vec3 own = r.axis(ofCube.face / 2).times(ofCube.face % 2 == 0 ? -1 : 1);
                assertEquals(1, own.dot(ofCube.normal()), "the face is the cube's own");
            }
        }
        assertTrue(hits > 20_000);
    }

    @Test
    void boundsAndVolumeAreTight() {
        RandomRays random = new RandomRays(145);
        for (int i = 0; i < 2000; i++) {
            Rotation r = random.rotation();
            Vec3 c = random.inCube();
            Primitive cube = new CubePrimitive(c, 0.5, r);
            for (int k = 0; k < 8; k++) {
                Vec3 corner = c.plus(r.apply(new Vec3((k & 1) - 0.5, (k >> 1 & 1) - 0.5, (k >> 2) - 0.5)));
                Vec3 inner = c.plus(corner.minus(c).times(1 - 1e-12));
                Vec3 outer = c.plus(corner.minus(c).times(1 + 1e-12));
                assertTrue(cube.bounds().contains(inner));
                assertTrue(cube.contains(inner.x(), inner.y(), inner.z()));
                assertFalse(cube.contains(outer.x(), outer.y(), outer.z()));
            }
            for (int k = 0; k < 3; k++) {
                Vec3 row = k == 0 ? r.r0() : k == 1 ? r.r1() : r.r2();
                double widest = Math.abs(row.x()) + Math.abs(row.y()) + Math.abs(row.z());
                assertEquals(widest, cube.bounds().extent().component(k), 1e-14);
            }
        }
    }
}
