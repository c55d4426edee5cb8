package enlightenment.mesh;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.math.Vec3;
import java.util.Arrays;
import org.junit.jupiter.api.Test;

/** What closes a hole lies in its rim's plane here, so that volumes are known. */
class HolesTest {
    /** A prism over a regular polygon of radius 1, from z = 0 to z = height, with the numbers of ends that are there: bottom, top. */
    private static TriangleMesh prism(int sides, double height, boolean hasBottom, boolean hasTop) {
        double[] positions = new double[6 * sides];
        for (int i = 0; i < 2 * sides; i++) {
            double angle = 2 * Math.PI * (i % sides) / sides;
            positions[3 * i] = Math.cos(angle);
            positions[3 * i + 1] = Math.sin(angle);
            positions[3 * i + 2] = i < sides ? 0 : height;
        }
        Ints indices = new Ints(1);
        for (int i = 0; i < sides; i++) {
            int next = (i + 1) % sides;
            add(indices, i, next, sides + next);
            add(indices, i, sides + next, sides + i);
        }
        for (int i = 1; i + 1 < sides; i++) {
            if (hasBottom) {
                add(indices, 0, i + 1, i);
            }
            if (hasTop) {
                add(indices, sides, sides + i, sides + i + 1);
            }
        }
        return TriangleMesh.of(positions, indices.toArray());
    }

    private static void add(Ints to, int a, int b, int c) {
        to.add(a);
        to.add(b);
        to.add(c);
    }

    private static double area(int sides) {
        return sides / 2.0 * Math.sin(2 * Math.PI / sides);
    }

    @Test
    void closedMeshesHaveTheVolumeOfTheWhole() {
        for (int ends = 0; ends < 3; ends++) {
            TriangleMesh open = prism(7, 2, ends == 1, ends == 2);
            assertFalse(open.isClosed());
            TriangleMesh closed = open.withoutHoles(1).orElseThrow();
            assertTrue(closed.isClosed());
            assertEquals(2 * area(7), closed.volume(), 1e-12);
            assertEquals(prism(7, 2, true, true).triangles(), closed.triangles());
            for (int t = open.triangles(); t < closed.triangles(); t++) {
                Vec3 n = closed.areaNormal(t).normalized();
                boolean isTop = closed.position(closed.vertex(t, 0)).z() > 1;
                assertEquals(isTop ? 1 : -1, n.z(), 1e-12);
            }
        }
    }

    @Test
    void largeHolesStayOpen() {
        TriangleMesh open = prism(6, 2, true, false);
        double share = area(6) / (area(6) + 6 * 2 * 1);
        assertTrue(open.withoutHoles(share * 1.001).isPresent());
        assertFalse(open.withoutHoles(share * 0.999).isPresent());
    }

    @Test
    void closedMeshesHaveNoHoles() {
        assertFalse(prism(5, 1, true, true).withoutHoles(1).isPresent());
    }

    @Test
    void rimsThatTouchStayOpen() {
        // Two open tetrahedra with one common vertex on both rims.
        double[] positions = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, -1, 0, 0, 0, -1, 0, 0, 0, -1};
        int[] indices = {0, 1, 3, 1, 2, 3, 2, 0, 3, 0, 4, 6, 4, 5, 6, 5, 0, 6};
        assertFalse(TriangleMesh.of(positions, indices).withoutHoles(1).isPresent());
    }

    @Test
    void rimsAreEdgesOfSmoothMeshesAndTextureCoordinatesStay() {
        TriangleMesh open = prism(8, 3, true, false).smooth();
        float[] uv = new float[2 * open.vertices()];
        Arrays.fill(uv, 0.25f);
        TriangleMesh closed = open.withUv(uv).withoutHoles(1).orElseThrow();
        for (int v = 0; v < open.vertices(); v++) {
            assertEquals(open.normal(v), closed.normal(v));
        }
        for (int t = open.triangles(); t < closed.triangles(); t++) {
            for (int corner = 0; corner < 3; corner++) {
                assertEquals(1, closed.normal(closed.vertex(t, corner)).z(), 1e-6);
                assertEquals(0.25, closed.uv(closed.vertex(t, corner), 0));
            }
        }
    }

    @Test
    void coordinatesOfFloatsStayFloats() {
        float[] positions = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
        TriangleMesh open = TriangleMesh.of(positions, new int[] {0, 1, 3, 1, 2, 3, 2, 0, 3});
        TriangleMesh closed = open.withoutHoles(1).orElseThrow();
        assertTrue(closed.isOfFloats());
        assertEquals(1.0 / 6, closed.volume(), 1e-12);
    }
}
