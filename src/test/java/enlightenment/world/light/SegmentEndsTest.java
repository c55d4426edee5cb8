package enlightenment.world.light;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.camera.Camera;
import enlightenment.color.DisplayRgb;
import enlightenment.geometry.Box;
import enlightenment.geometry.Cone;
import enlightenment.geometry.Cube;
import enlightenment.geometry.Cylinder;
import enlightenment.geometry.Disk;
import enlightenment.geometry.Rectangle;
import enlightenment.geometry.Shape;
import enlightenment.geometry.Sphere;
import enlightenment.geometry.Torus;
import enlightenment.geometry.Triangle;
import enlightenment.material.Material;
import enlightenment.material.Texture;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.primitive.Hit;
import enlightenment.primitive.Primitive;
import enlightenment.primitive.Ray;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.world.CompiledScene;
import enlightenment.world.SceneCompiler;
import enlightenment.world.Tracer;
import enlightenment.world.parts.RayCounters;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** Segments from one point to some others: what is known beforehand of what is in their way, against a loop over everything. */
class SegmentEndsTest {
    private static final Material WHITE = Material.Matte.of(Texture.of(DisplayRgb.WHITE));

    /** How many segments share a beginning. */
    private static final int SEGMENTS = 8;

    private final SegmentEnds ends = new SegmentEnds();
    private final double[][] points = new double[SEGMENTS][];
    private final Ray ray = new Ray();
    private int free;
    private int occluded;
    private int asked;

    private static CompiledScene compile(List<Shape> shapes) {
        Scene.Builder b = Scene.builder()
                .camera(new Camera.Perspective(ExactPoint.of(0, 0, -9), ExactPoint.of(0, 0, 0), Vec3.Y, 60));
        shapes.forEach(s -> b.object(s, WHITE));
        Scene scene = b.build();
        return SceneCompiler.compile(scene, RenderSettings.of(scene));
    }

    private static Vec3 vector(Random r, double size) {
        return new Vec3(r.nextDouble() - 0.5, r.nextDouble() - 0.5, r.nextDouble() - 0.5).times(2 * size);
    }

    private static ExactPoint point(Random r, double size) {
        return ExactPoint.ORIGIN.plus(vector(r, size));
    }

    private static Shape shape(Random r, double size) {
        ExactPoint c = point(r, 3);
        Vec3 u = vector(r, size);
        Vec3 v = r.nextBoolean() ? vector(r, size) : new Vec3(0, size, 0);
        return switch (r.nextInt(9)) {
            case 0 -> Sphere.of(c, size);
            case 1 -> new Box(c, c.plus(new Vec3(size, 2 * size, size / 2)));
            case 2 -> new Cube(c, size, new Vec3(90 * r.nextInt(3), 360 * r.nextDouble(), 20));
            case 3 -> new Torus(c, u, size, size / 3);
            case 4 -> new Triangle(c, c.plus(u), c.plus(v));
            case 5 -> new Cylinder(c, c.plus(u), size / 2, r.nextBoolean());
            case 6 -> new Cone(c, c.plus(u), size / 2, size * r.nextInt(2) / 4, r.nextBoolean());
            case 7 -> new Disk(c, u, size);
            default -> new Rectangle(c, c.plus(v), c.plus(v.plus(u.cross(v))), c.plus(u.cross(v)));
        };
    }

    private static double[] array(Vec3 v) {
        return new double[] {v.x(), v.y(), v.z()};
    }

    private static double[] inFrame(CompiledScene scene, ExactPoint p) {
        return array(scene.frame.toFrame(p));
    }

    private void prepare(Tracer tracer, double[] from) {
        ends.clear(-1);
        for (double[] p : points) {
            ends.add(p[0], p[1], p[2]);
        }
        ends.finish();
        tracer.prepareSegments(from[0], from[1], from[2], -1, ends, SEGMENTS);
    }

    private void aim(double[] from, double[] to) {
        ray.set(from[0], from[1], from[2], to[0] - from[0], to[1] - from[1], to[2] - from[2], 0);
    }

    /** Where the ray meets something first, at most at 1; infinite if it does not. */
    private double firstMet(CompiledScene scene) {
        double first = Double.POSITIVE_INFINITY;
        for (Primitive p : scene.primitives) {
            double t = p.nearest(ray, 1);
            first = t <= 1 ? Math.min(first, t) : first;
        }
        return first;
    }

    private boolean ask(Tracer tracer, RayCounters counters) {
        long before = counters.shadowRays;
        boolean isOccluded = tracer.occludedSegment(ray);
        asked++;
        free += counters.shadowRays == before ? 1 : 0;
        occluded += isOccluded ? 1 : 0;
        return isOccluded;
    }

    private void compare(Random r, int count, double size, int beginnings) {
        List<Shape> shapes = new ArrayList<>();
        for (int k = 0; k < count; k++) {
            shapes.add(shape(r, size * (0.2 + r.nextDouble())));
        }
        CompiledScene scene = compile(shapes);
        RayCounters counters = new RayCounters(scene.kindNames.size());
        Tracer tracer = new Tracer(scene, counters);
        for (int k = 0; k < beginnings; k++) {
            ExactPoint center = point(r, 4);
            double radius = Math.pow(10, -3 * r.nextDouble());
            for (int p = 0; p < SEGMENTS; p++) {
                points[p] = inFrame(scene, center.plus(vector(r, 1).normalized().times(radius)));
            }
            // Sometimes among the ends.
            double[] from = inFrame(scene, r.nextInt(8) == 0 ? center.plus(vector(r, radius)) : point(r, 4));
            prepare(tracer, from);
            for (double[] to : points) {
                aim(from, to);
                assertEquals(firstMet(scene) <= 1, ask(tracer, counters), count + " things, beginning " + k);
            }
        }
    }

    @Test
    void whatIsLeftOutIsInTheWayOfNoSegment() {
        Random r = new Random(7);
        for (int round = 0; round < 200; round++) {
            compare(r, 1 + r.nextInt(10), 1, 40);
        }
        assertTrue(free > asked / 5 && occluded > asked / 20, free + " free and " + occluded + " occluded of " + asked);
    }

    @Test
    void withAHierarchyTheSegmentsThatAreOccludedAreTheSame() {
        Random r = new Random(8);
        for (int round = 0; round < 8; round++) {
            compare(r, SceneCompiler.LOOP_LIMIT + 1 + r.nextInt(100), 0.5, 400);
        }
        assertTrue(occluded > asked / 10 && occluded < asked / 2, occluded + " occluded of " + asked);
    }

    /** A wall of a room, from a corner along two of its edges. */
    private static Rectangle wall(double x, double y, double z, Vec3 u, Vec3 v) {
        ExactPoint corner = ExactPoint.of(x, y, z);
        return new Rectangle(corner, corner.plus(v), corner.plus(v).plus(u), corner.plus(u));
    }

    /** Things that stand on the floor, on and against one another. */
    private static List<Shape> room() {
        Vec3 x = new Vec3(4, 0, 0);
        Vec3 y = new Vec3(0, 3, 0);
        Vec3 z = new Vec3(0, 0, 5);
        List<Shape> all = new ArrayList<>(
                List.of(wall(-2, 0, -2, x, z), wall(-2, 3, -2, x, z), wall(-2, 0, -2, y, z), wall(2, 0, -2, y, z)));
        all.addAll(List.of(wall(-2, 0, -2, x, y), wall(-2, 0, 3, x, y)));
        all.add(new Box(ExactPoint.of(-1.5, 0, 1), ExactPoint.of(-0.5, 1, 2)));
        all.add(new Box(ExactPoint.of(-1.25, 1, 1), ExactPoint.of(-0.75, 1.5, 1.5)));
        all.add(Sphere.of(ExactPoint.of(0, 0.5, 1.5), 0.5));
        all.add(new Cube(ExactPoint.of(1.25, 0.25, 0), 0.5, new Vec3(0, 30, 0)));
        all.add(new Cylinder(ExactPoint.of(1.25, 0.5, 0), ExactPoint.of(1.25, 1, 0), 0.25, true));
        all.add(new Triangle(ExactPoint.of(-2, 0, 0), ExactPoint.of(-2, 1, 0), ExactPoint.of(-1, 0, 0)));
        return all;
    }

    private static boolean look(Tracer tracer, CompiledScene scene, Random r, Hit hit) {
        double[] eye = inFrame(scene, ExactPoint.of(0.3, 1.4, 0.2));
        Vec3 d = vector(r, 1);
        return tracer.trace(new Ray().set(eye[0], eye[1], eye[2], d.x(), d.y(), d.z(), 0), hit);
    }

    private static boolean sees(Hit from, double[] to) {
        double height = from.nx * (to[0] - from.px) + from.ny * (to[1] - from.py) + from.nz * (to[2] - from.pz);
        return height * from.side > 0;
    }

    private static boolean isOpen(Hit h) {
        return h.primitive.isFlat() || h.primitive.isConvex() && h.side == Ray.OUTSIDE;
    }

    @Test
    void betweenSurfacesThatTouchSegmentsAreOccludedByWhatIsStrictlyBetween() {
        Random r = new Random(9);
        CompiledScene scene = compile(room());
        RayCounters counters = new RayCounters(scene.kindNames.size());
        Tracer tracer = new Tracer(scene, counters);
        Hit begin = new Hit();
        Hit[] last = new Hit[SEGMENTS];
        int differ = 0;
        for (int k = 0; k < 20_000; k++) {
            if (!look(tracer, scene, r, begin) || !isOpen(begin)) {
                continue;
            }
            for (int p = 0; p < SEGMENTS; p++) {
                last[p] = new Hit();
                assertTrue(look(tracer, scene, r, last[p]));
                points[p] = array(last[p].point());
            }
            double[] from = array(begin.point());
            prepare(tracer, from);
            for (int p = 0; p < SEGMENTS; p++) {
                if (!isOpen(last[p]) || !sees(begin, points[p]) || !sees(last[p], from)) {
                    continue;
                }
                aim(from, points[p]);
                ray.from(begin.primitive, begin.side).alsoFrom(last[p].primitive, last[p].side);
                double t = firstMet(scene);
                if (ask(tracer, counters) != t <= 1) {
                    differ++;
                    assertTrue(t < 1e-12 || t > 1 - 1e-12 && t <= 1, "met at " + t);
                }
            }
        }
        assertTrue(asked > 30_000 && occluded > 1000 && differ < asked / 1000, asked + " " + occluded + " " + differ);
    }
}
