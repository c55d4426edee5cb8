package enlightenment.primitive;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.math.Vec3;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Rays of the isometric view begin behind their origins: what lies there is met as if the origin was where they begin. */
class RaysFromBehindTest {
    private static final double BACK = 16;
    private static final int RAYS = 4000;

    private static List<Primitive> primitives(RandomRays random) {
        List<Primitive> all = new ArrayList<>();
        for (String kind : Subject.KINDS) {
            all.add(Subject.random(kind, random, 1.5, random.inCube()).ours());
        }
        Vec3 a = random.inCube().times(0.5);
        Vec3[] axes = {Vec3.X, Vec3.Y, Vec3.Z};
        for (int k = 0; k < 3; k++) {
            Vec3 up = axes[(k + 1) % 3];
            Vec3 right = axes[(k + 2) % 3];
            all.add(new RectanglePrimitive(a, a.plus(up), a.plus(up).plus(right), a.plus(right)));
        }
        all.add(new DiskPrimitive(a, random.direction(), 0.7));
        return all;
    }

    @Test
    void primitivesBehindTheOriginAreMet() {
        RandomRays random = new RandomRays(77);
        int met = 0;
        for (int i = 0; i < RAYS; i++) {
            for (Primitive p : primitives(random)) {
                Vec3 d = random.direction();
                Vec3 o = random.inCube().plus(d.times(4 * random.uniform() - 2));
                Ray behind = new Ray().set(o.x(), o.y(), o.z(), d.x(), d.y(), d.z(), -BACK);
                double expected = p.nearest(Ray.of(o.minus(d.times(BACK)), d), Double.MAX_VALUE) - BACK;
                double t = p.nearest(behind, Double.MAX_VALUE);
                if (expected < Double.MAX_VALUE && t < Double.MAX_VALUE) {
                    assertEquals(expected, t, 1e-6, p.getClass().getSimpleName());
                    met++;
                } else {
                    // Rounding decides at outlines.
                    assertEquals(
                            expected < Double.MAX_VALUE,
                            t < Double.MAX_VALUE,
                            p.getClass().getSimpleName());
                }
            }
        }
        assertTrue(met > RAYS);
    }
}
