package enlightenment.primitive;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.math.Vec3;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** A primitive that is a part of something smooth has a shading normal of its own, and the geometry does not see it. */
class ShadingNormalTest {
    private static final Vec3[] CORNERS = {new Vec3(1, 0, 4), new Vec3(0, 1, 4), new Vec3(0, 0, 3)};

    /** A triangle of a net of the unit sphere around (0, 0, 4), with that sphere's normals. */
    private static final class PartOfABall extends TrianglePrimitive {
        PartOfABall() {
            super(CORNERS[0], CORNERS[1], CORNERS[2]);
        }

        @Override
        public Vec3 shadingNormal(Hit hit) {
            return hit.point().minus(new Vec3(0, 0, 4)).normalized();
        }
    }

    @Test
    void onlyShadingSeesTheSmoothNormal() {
        Primitive plain = new TrianglePrimitive(CORNERS[0], CORNERS[1], CORNERS[2]);
        Primitive smooth = new PartOfABall();
        assertArrayEquals(plain.parameters(), smooth.parameters());
        Random random = new Random(1);
        int hits = 0;
        for (int i = 0; i < 200; i++) {
            Ray ray = Ray.of(new Vec3(random.nextDouble(), random.nextDouble(), 0), Vec3.Z);
            Hit expected = new Hit();
            Hit hit = new Hit();
            assertEquals(plain.intersect(ray, expected), smooth.intersect(ray, hit));
            if (hit.primitive == null) {
                continue;
            }
            hits++;
            assertEquals(expected.t, hit.t);
            assertEquals(expected.point(), hit.point());
            assertEquals(expected.normal(), hit.normal());
            assertEquals(expected.side, hit.side);
            assertEquals(expected.normal(), expected.primitive.shadingNormal(expected));
            Vec3 normal = hit.primitive.shadingNormal(hit);
            assertNotEquals(hit.normal(), normal);
            assertEquals(1, normal.length(), 1e-15);
            assertTrue(Math.abs(normal.dot(hit.normal())) > 0.5);
        }
        assertTrue(hits > 50);
    }
}
