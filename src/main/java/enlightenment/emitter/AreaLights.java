package enlightenment.emitter;

import enlightenment.math.Vec3;
import enlightenment.primitive.AxialPrimitive;
import enlightenment.primitive.BoxPrimitive;
import enlightenment.primitive.CubePrimitive;
import enlightenment.primitive.DiskPrimitive;
import enlightenment.primitive.Primitive;
import enlightenment.primitive.RectanglePrimitive;
import enlightenment.primitive.SpherePrimitive;
import enlightenment.primitive.TorusPrimitive;
import enlightenment.primitive.TrianglePrimitive;

/** Makes the lights of emitting surfaces of primitives. */
public final class AreaLights {
    private AreaLights() {}

    /**
     * Makes the light of a face of a primitive: the whole primitive if it has one face.
     *
     * @param face in 0..{@link Primitive#faceCount}−1, as {@link enlightenment.primitive.Hit#face}
     * @param sides that emit; solids that emit on both are not sampled from inside, where every direction hits them
     * @return null if the face has no area in the frame, so that it cannot be sampled
     */
    public static AreaLight of(Primitive primitive, int face, LightSides sides) {
        if (primitive instanceof SpherePrimitive s) {
            return sides == LightSides.BACK
                    ? new InnerSphereLight(s.center(), s.radius())
                    : new SphereLight(s.center(), s.radius());
        } else if (primitive instanceof RectanglePrimitive r) {
            return rectangle(r.parameters(), sides);
        } else if (primitive instanceof TrianglePrimitive t) {
            return triangle(t.parameters(), sides);
        } else if (primitive instanceof DiskPrimitive d) {
            return new DiskLight(d.center(), d.normal(), d.radius(), sides);
        } else if (primitive instanceof AxialPrimitive a) {
            return axial(a, face, sides);
        } else if (primitive instanceof TorusPrimitive t) {
            return new TorusLight(t.center(), t.axis(), t.majorRadius(), t.minorRadius(), ofSolid(sides));
        } else if (primitive instanceof BoxPrimitive b) {
            return boxFace(b.bounds().min(), b.bounds().max(), face, ofSolid(sides));
        } else if (primitive instanceof CubePrimitive c) {
            return cubeFace(c, face, ofSolid(sides));
        }
        throw new AssertionError("no light of the form " + primitive.getClass().getSimpleName());
    }

    /** From inside a solid every direction hits it, so that only one that emits on its inside alone is sampled from there. */
    private static LightSides ofSolid(LightSides sides) {
        return sides == LightSides.BACK ? LightSides.BACK : LightSides.FRONT;
    }

    private static Vec3 vector(double[] numbers, int k) {
        return new Vec3(numbers[3 * k], numbers[3 * k + 1], numbers[3 * k + 2]);
    }

    /** The corners are lower left, upper left, upper right and lower right. */
    private static AreaLight rectangle(double[] corners, LightSides sides) {
        Vec3 a = vector(corners, 0);
        return parallelogram(a, vector(corners, 3).minus(a), vector(corners, 1).minus(a), sides);
    }

    private static AreaLight parallelogram(Vec3 corner, Vec3 right, Vec3 up, LightSides sides) {
        return up.cross(right).maxAbs() > 0 ? new ParallelogramLight(corner, right, up, sides) : null;
    }

    private static AreaLight triangle(double[] corners, LightSides sides) {
        Vec3 a = vector(corners, 0);
        Vec3 b = vector(corners, 1);
        Vec3 c = vector(corners, 2);
        return b.minus(a).cross(c.minus(a)).maxAbs() > 0 ? new TriangleLight(a, b, c, sides) : null;
    }

    private static AreaLight axial(AxialPrimitive a, int face, LightSides sides) {
        double[] p = a.parameters();
        Vec3 toTop = vector(p, 3);
        if (face == AxialPrimitive.LATERAL) {
            return new LateralLight(
                    a.base(), toTop, a.baseRadius(), a.topRadius(), a.isCapped() ? ofSolid(sides) : sides);
        }
        boolean top = face == AxialPrimitive.TOP;
        double radius = top ? a.topRadius() : a.baseRadius();
        if (!a.isCapped() || !(radius > 0)) {
            return null;
        }
        Vec3 outward = top ? toTop.normalized() : toTop.normalized().negated();
        return new DiskLight(top ? a.top() : a.base(), outward, radius, ofSolid(sides));
    }

    private static AreaLight boxFace(Vec3 min, Vec3 max, int face, LightSides sides) {
        Vec3 extent = max.minus(min);
        boolean upper = face % 2 == 1;
        // Assigned, not computed, as in the primitive.
        Vec3 corner = new Vec3(
                upper && face / 2 == 0 ? max.x() : min.x(),
                upper && face / 2 == 1 ? max.y() : min.y(),
                upper && face / 2 == 2 ? max.z() : min.z());
        return face(
                corner,
                new Vec3(extent.x(), 0, 0),
                new Vec3(0, extent.y(), 0),
                new Vec3(0, 0, extent.z()),
                face,
                sides);
    }

    /** One of six faces of a box with these edges, from its lowest corner. */
    private static AreaLight face(Vec3 corner, Vec3 x, Vec3 y, Vec3 z, int face, LightSides sides) {
        Vec3 p = face / 2 == 0 ? y : face / 2 == 1 ? z : x;
        Vec3 q = face / 2 == 0 ? z : face / 2 == 1 ? x : y;
        // p × q points along the axis: outward on the upper face.
        return face % 2 == 1 ? parallelogram(corner, q, p, sides) : parallelogram(corner, p, q, sides);
    }

    private static AreaLight cubeFace(CubePrimitive c, int face, LightSides sides) {
        Vec3 x = c.edge(0);
        Vec3 y = c.edge(1);
        Vec3 z = c.edge(2);
        Vec3 corner = c.center().minus(x.plus(y).plus(z).times(0.5));
        return face(face % 2 == 1 ? corner.plus(c.edge(face / 2)) : corner, x, y, z, face, sides);
    }
}
