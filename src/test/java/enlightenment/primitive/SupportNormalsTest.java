package enlightenment.primitive;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.frame.Rotation;
import enlightenment.math.Vec3;
import java.util.List;
import org.junit.jupiter.api.Test;

/** The plane of a face has the face's own normal, whichever side of a solid the face is on. */
class SupportNormalsTest {
    private static final List<Primitive> FLAT_FACED = List.of(
            new BoxPrimitive(new Vec3(-1, 0.5, 2), new Vec3(1, 1, 3)),
            new CubePrimitive(new Vec3(1, 2, 3), 0.7, Rotation.ofDegrees(new Vec3(20, 33, -50))),
            new CylinderPrimitive(new Vec3(0, 1, 0), new Vec3(0.3, 2, 0.2), 0.9, true),
            new ConePrimitive(new Vec3(0, 1, 0), new Vec3(0.3, 2, 0.2), 0.9, 0.4, true),
            new RectanglePrimitive(new Vec3(0, 0, 0), new Vec3(0, 1, 0), new Vec3(1, 1, 0.5), new Vec3(1, 0, 0.5)),
            new TrianglePrimitive(new Vec3(0, 0, 0), new Vec3(0, 1, 0), new Vec3(1, 1, 0.5)));

    @Test
    void thePlaneOfAFaceHasTheFacesOwnNormal() {
        for (Primitive p : FLAT_FACED) {
            int planes = 0;
            for (int face = 0; face < p.faceCount(); face++) {
                if (p.support(face) instanceof SupportSurface.Plane plane) {
                    check(p, face, plane);
                    planes++;
                }
            }
            assertTrue(planes > 0);
        }
    }

    private static void check(Primitive p, int face, SupportSurface.Plane plane) {
        Vec3[] corners = plane.corners();
        Vec3 middle = Vec3.ZERO;
        for (Vec3 corner : corners) {
            middle = middle.plus(corner.times(1.0 / corners.length));
        }
        Vec3 n = plane.unitNormal();
        Hit hit = new Hit();
        assertTrue(p.intersect(Ray.of(middle.plus(n.times(0.1)), n.negated()), hit));
        assertEquals(face, hit.face);
        assertEquals(1, n.dot(new Vec3(hit.nx, hit.ny, hit.nz)), 1e-9, p + ", face " + face);
    }
}
