package enlightenment.primitive;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.geometry.Transform;
import enlightenment.math.Vec3;
import enlightenment.mesh.TestMeshes;
import java.util.Arrays;
import org.junit.jupiter.api.Test;

/**
 * A ball of 20·4^k triangles goes to the ball. With h the size of a triangle, places and interpolated normals are off by h², a quarter for
 * each cut; normals of triangles by h, a half: what glass refracts by these converges no faster.
 */
class MeshConvergenceTest {
    private static final int CUTS = 5;
    private static final int RAYS = 40;

    /** Root mean squares, by cuts: of distances, of normals of vertices, of those of triangles, of directions behind glass. */
    private record Errors(
            double[] distance, double[] shading, double[] surface, double[] mirrored, double[] refracted) {
        void check(double[] all, double least, double most) {
            for (int k = 2; k < CUTS; k++) {
                double ratio = all[k - 1] / all[k];
                assertTrue(ratio > least && ratio < most, Arrays.toString(all));
            }
        }
    }

    private static Errors errors() {
        Errors e = new Errors(new double[CUTS], new double[CUTS], new double[CUTS], new double[CUTS], new double[CUTS]);
        for (int cuts = 1; cuts < CUTS; cuts++) {
            MeshPrimitive mesh = MeshLeavingTest.placed(TestMeshes.ball(cuts), Transform.IDENTITY);
            int n = 0;
            double[] sums = new double[5];
            for (int k = 0; k < RAYS * RAYS; k++) {
                // Parallel rays through the middle of the ball: away from silhouettes and total reflection.
                double x = 1.4 * ((k % RAYS + 0.5) / RAYS - 0.5);
                double y = 1.4 * ((k / RAYS + 0.5) / RAYS - 0.5);
                if (x * x + y * y > 0.36) {
                    continue;
                }
                add(mesh, new Vec3(x, y, -Math.sqrt(1 - x * x - y * y)), sums);
                n++;
            }
            e.distance[cuts] = Math.sqrt(sums[0] / n);
            e.shading[cuts] = Math.sqrt(sums[1] / n);
            e.surface[cuts] = Math.sqrt(sums[2] / n);
            e.mirrored[cuts] = Math.sqrt(sums[3] / n);
            e.refracted[cuts] = Math.sqrt(sums[4] / n);
        }
        return e;
    }

    /** @param p where the ray along z meets the ball */
    private static void add(MeshPrimitive mesh, Vec3 p, double[] sums) {
        Ray ray = Ray.of(new Vec3(p.x(), p.y(), -3), Vec3.Z);
        Hit hit = new Hit();
        assertTrue(mesh.intersect(ray, hit) && mesh.shadingNormal(hit));
        Vec3 shading = new Vec3(hit.sx, hit.sy, hit.sz);
        Vec3 n = hit.normal();
        sums[0] += square(hit.t - (p.z() + 3));
        sums[1] += shading.minus(p).lengthSquared();
        sums[2] += n.minus(p).lengthSquared();
        sums[3] += mirrored(Vec3.Z, shading).minus(mirrored(Vec3.Z, p)).lengthSquared();
        // The chord of a ball leaves it as it came in: the exit's normal is known.
        Vec3 within = refracted(Vec3.Z, p, 1 / 1.5);
        Vec3 exit = p.minus(within.times(2 * within.dot(p)));
        Vec3 expected = refracted(within, exit.negated(), 1.5);
        Vec3 d = refracted(Vec3.Z, n, 1 / 1.5);
        Ray inside =
                new Ray().set(hit.px, hit.py, hit.pz, d.x(), d.y(), d.z(), 0).from(hit, Ray.INSIDE);
        assertTrue(mesh.intersect(inside, hit));
        assertEquals(Ray.INSIDE, hit.side);
        sums[4] += refracted(d, hit.normal().negated(), 1.5).minus(expected).lengthSquared();
    }

    private static double square(double v) {
        return v * v;
    }

    private static Vec3 mirrored(Vec3 d, Vec3 n) {
        return d.minus(n.times(2 * d.dot(n)));
    }

    /** Snell's law; the normal is on the side that light comes from. */
    private static Vec3 refracted(Vec3 d, Vec3 n, double eta) {
        double c = -d.dot(n);
        double root = 1 - eta * eta * (1 - c * c);
        assertTrue(root > 0);
        return d.times(eta).plus(n.times(eta * c - Math.sqrt(root)));
    }

    @Test
    void aBallOfTrianglesGoesToTheBall() {
        Errors e = errors();
        e.check(e.distance, 3.4, 4.6);
        e.check(e.shading, 3.4, 4.6);
        e.check(e.mirrored, 3.4, 4.6);
        e.check(e.surface, 1.7, 2.3);
        e.check(e.refracted, 1.6, 2.8);
        // In its middle a triangle with edges e is e²/6 below the ball, seen along the ray at cosines down to 0.8.
        double edge = Math.toRadians(63.4) / 16;
        assertTrue(e.distance[4] < edge * edge / 6 / 0.8, "" + e.distance[4]);
    }
}
