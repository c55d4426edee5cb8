package enlightenment.primitive;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.frame.Rotation;
import enlightenment.math.Vec3;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** N15: no ray passes between flat primitives that share corners. */
class WatertightTest {
    private static final double[] SCALES = {1e-9, 1, 1e9};
    private static final int FEW = 60_000;
    private static final int MANY = 1_000_000;

    @Test
    void noRayPassesTheEdgeThatTwoRectanglesShare() {
        hinges(FEW);
    }

    @Test
    @Tag("full")
    void noneOfAMillionRaysPassesTheEdgeThatTwoRectanglesShare() {
        hinges(MANY);
    }

    @Test
    void noRayLeavesARoomOfRectangles() {
        rooms(FEW);
    }

    @Test
    @Tag("full")
    void noneOfAMillionRaysLeavesARoomOfRectangles() {
        rooms(MANY);
    }

    @Test
    void noRayPassesAClosedMesh() {
        meshes(3000);
    }

    @Test
    @Tag("full")
    void noneOfManyRaysPassesAClosedMesh() {
        meshes(20_000);
    }

    private static void hinges(int rays) {
        for (double scale : SCALES) {
            RandomRays random = new RandomRays(15);
            for (int i = 0; i < rays; i++) {
                boolean aligned = i % 2 == 0;
                Vec3[] frame = aligned ? alignedAxes(random) : tiltedAxes(random);
                Vec3 a = random.inCube().times(scale);
                Vec3 b = a.plus(frame[0].times(scale));
                // The viewer sees one rectangle on each side of the edge: an outer or an inner corner, or a flat joint.
                double fold = random.index(3) - 1;
                Vec3 left = aligned && fold != 0 ? frame[2].times(fold) : frame[1].negated();
                Vec3 right = aligned ? frame[1] : frame[1].plus(frame[2].times(fold * random.uniform()));
                Primitive one = spanned(a, b, left.times(scale));
                Primitive two = spanned(a, b, right.times(scale));
                Vec3 viewer = a.plus(frame[0].times(scale * random.signed()))
                        .plus(right.minus(left).times(0.2 * scale * random.signed()))
                        .plus(left.plus(right)
                                .plus(frame[2].times(fold == 0 ? 1 : 0))
                                .times(scale * away(random)));
                Vec3 across = right.minus(left).times(random.decade(-16, -3) * scale);
                Vec3 target = a.plus(frame[0].times(scale * (0.05 + 0.9 * random.uniform())))
                        .plus(across);
                Ray ray = Ray.of(viewer, target.minus(viewer));
                boolean met = one.nearest(ray, 2) <= 2 || two.nearest(ray, 2) <= 2;
                assertTrue(met, "ray " + i + " at scale " + scale + (aligned ? " aligned" : " tilted"));
            }
        }
    }

    private static double away(RandomRays random) {
        return (random.index(2) == 0 ? 0.7 : -0.7) * (0.5 + random.uniform());
    }

    private static Vec3[] alignedAxes(RandomRays random) {
        Vec3[] axes = {Vec3.X, Vec3.Y, Vec3.Z};
        int turn = random.index(3);
        return new Vec3[] {axes[turn], axes[(turn + 1) % 3], axes[(turn + 2) % 3]};
    }

    private static Vec3[] tiltedAxes(RandomRays random) {
        Rotation r = random.rotation();
        return new Vec3[] {r.axis(0), r.axis(1), r.axis(2)};
    }

    private static RectanglePrimitive spanned(Vec3 a, Vec3 b, Vec3 side) {
        return new RectanglePrimitive(a, b, b.plus(side), a.plus(side));
    }

    /** From anywhere in a closed room, walls and floor grazed at will, every ray meets a wall, and not behind it. */
    private static void rooms(int rays) {
        for (double scale : SCALES) {
            for (int turned = 0; turned < 3; turned++) {
                RandomRays random = new RandomRays(151 + turned);
                Vec3[] corners = roomCorners(random, scale, turned);
                RectanglePrimitive[] walls = walls(corners);
                for (int i = 0; i < rays / 3; i++) {
                    Vec3 from = inside(corners, nearFace(random), nearFace(random), random.uniform());
                    Vec3 to = target(corners, random);
                    Ray ray = Ray.of(from, to.minus(from));
                    double t = Primitive.MISS;
                    for (RectanglePrimitive wall : walls) {
                        t = Math.min(t, wall.nearest(ray, Double.MAX_VALUE));
                    }
                    assertTrue(t < Primitive.MISS, "ray " + i + " at scale " + scale + " left the room");
                    assertInside(corners, from.plus(to.minus(from).times(t)), i);
                }
            }
        }
    }

    /** 0 is the axes' room, 1 one turned about y only, 2 one in general position. */
    private static Vec3[] roomCorners(RandomRays random, double scale, int turned) {
        Rotation r = turned == 0
                ? Rotation.IDENTITY
                : turned == 1 ? Rotation.aboutY(180 * random.signed()) : random.rotation();
        Vec3 middle = random.inCube().times(2 * scale);
        Vec3[] corners = new Vec3[8];
        for (int i = 0; i < 8; i++) {
            Vec3 v = new Vec3((i & 1) - 0.5, 0.7 * ((i >> 1 & 1) - 0.5), 1.3 * ((i >> 2) - 0.5));
            corners[i] = middle.plus(r.apply(v.times(scale)));
        }
        return corners;
    }

    private static RectanglePrimitive[] walls(Vec3[] c) {
        return new RectanglePrimitive[] {
            new RectanglePrimitive(c[0], c[2], c[6], c[4]),
            new RectanglePrimitive(c[1], c[3], c[7], c[5]),
            new RectanglePrimitive(c[0], c[1], c[5], c[4]),
            new RectanglePrimitive(c[2], c[3], c[7], c[6]),
            new RectanglePrimitive(c[0], c[1], c[3], c[2]),
            new RectanglePrimitive(c[4], c[5], c[7], c[6])
        };
    }

    private static Vec3 inside(Vec3[] c, double x, double y, double z) {
        return c[0].plus(c[1].minus(c[0]).times(x))
                .plus(c[2].minus(c[0]).times(y))
                .plus(c[4].minus(c[0]).times(z));
    }

    private static void assertInside(Vec3[] c, Vec3 p, int ray) {
        for (int k = 1; k <= 4; k *= 2) {
            Vec3 edge = c[k].minus(c[0]);
            double fraction = p.minus(c[0]).dot(edge) / edge.lengthSquared();
            assertTrue(Math.abs(fraction - 0.5) < 0.5 + 1e-12, "ray " + ray + " met a wall at " + fraction);
        }
    }

    /** A fraction that is often very close to 0. */
    private static double nearFace(RandomRays random) {
        return random.index(2) == 0 ? 0.02 + 0.96 * random.uniform() : Math.abs(random.decade(-14, -3));
    }

    /** A point at an edge or a corner, a little off. */
    private static Vec3 target(Vec3[] c, RandomRays random) {
        double off1 = random.decade(-16, -3);
        double off2 = random.index(3) == 0 ? random.decade(-16, -3) : random.uniform();
        double far = random.index(2) + off1;
        return switch (random.index(3)) {
            case 0 -> inside(c, 1 + off1, off2, far);
            case 1 -> inside(c, off2, far, 1 + off1);
            default -> inside(c, far, 1 + off1, off2);
        };
    }

    /** N17: from inside a closed mesh every ray that aims at an edge or at a vertex meets it. */
    private static void meshes(int rays) {
        Icosphere mesh = new Icosphere(new RandomRays(17), 3);
        assertEquals(1280, mesh.triangles().length);
        for (double shift : new double[] {0, 1e3, 1e6}) {
            TrianglePrimitive[] triangles = mesh.shifted(new Vec3(shift, -shift, shift / 3));
            Vec3[] vertices = mesh.shiftedVertices(new Vec3(shift, -shift, shift / 3));
            RandomRays random = new RandomRays(18);
            for (int i = 0; i < rays; i++) {
                int[] face = mesh.triangles()[random.index(mesh.triangles().length)];
                double along = i % 2 == 0 ? 0 : random.uniform();
                Vec3 p = vertices[face[0]];
                Vec3 target = p.plus(vertices[face[1]].minus(p).times(along));
                Vec3 from =
                        new Vec3(shift, -shift, shift / 3).plus(random.inCube().times(0.4));
                Ray ray = Ray.of(from, target.minus(from));
                boolean met = false;
                for (int k = 0; k < triangles.length && !met; k++) {
                    met = triangles[k].nearest(ray, Double.MAX_VALUE) < Primitive.MISS;
                }
                assertTrue(met, "ray " + i + " at shift " + shift);
            }
        }
    }

    @Test
    void aRectangleIsExactlyItsTwoTriangles() {
        RandomRays random = new RandomRays(21);
        int onlyJust = 0;
        for (int i = 0; i < 200_000; i++) {
            Vec3[] axes = i % 2 == 0 ? alignedAxes(random) : tiltedAxes(random);
            Vec3 a = random.inCube();
            Vec3 b = a.plus(axes[0]);
            Vec3 d = a.plus(axes[1].times(0.5));
            Vec3 c = b.plus(axes[1].times(0.5));
            Vec3 edge = a.plus(b.minus(a).times(random.uniform()))
                    .plus(random.inCube().times(random.decade(-17, -2)));
            Vec3 from = a.plus(axes[0].times(random.signed()))
                    .plus(axes[1].times(random.signed()))
                    .plus(axes[2].times(random.decade(-9, 2)));
            Ray ray = Ray.of(from, edge.minus(from));
            boolean whole = new RectanglePrimitive(a, b, c, d).nearest(ray, 10) < Primitive.MISS;
            boolean halves = new TrianglePrimitive(a, b, c).nearest(ray, 10) < Primitive.MISS
                    || new TrianglePrimitive(a, c, d).nearest(ray, 10) < Primitive.MISS;
            assertEquals(halves, whole, "ray " + i);
            onlyJust += whole ? 1 : 0;
        }
        assertTrue(onlyJust > 20_000 && onlyJust < 180_000, onlyJust + " hits");
    }
}
