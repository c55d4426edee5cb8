package enlightenment.importer.support;

import enlightenment.math.Vec3;
import enlightenment.mesh.TriangleMesh;

/** What a texture does to texture coordinates before it looks colours up: (a u + b v + c, d u + e v + f). A value. */
public record UvMap(double a, double b, double c, double d, double e, double f) {
    /** The map that changes nothing. */
    public static final UvMap IDENTITY = new UvMap(1, 0, 0, 0, 1, 0);

    /** The map of a transform in three dimensions, whose z does not count. */
    public static UvMap of(Affine m) {
        Vec3 x = m.x();
        Vec3 y = m.y();
        return new UvMap(x.x(), x.y(), m.offset().x(), y.x(), y.y(), m.offset().y());
    }

    /** Whether it only scales both coordinates by a factor above 0. */
    public boolean isScale() {
        return b == 0 && c == 0 && d == 0 && f == 0 && a == e && a > 0;
    }

    /** The first coordinate of what (u, v) is mapped to. */
    public double u(double u, double v) {
        return a * u + b * v + c;
    }

    /** The second one. */
    public double v(double u, double v) {
        return d * u + e * v + f;
    }

    /**
     * A mesh with mapped texture coordinates, which have v upwards before and after, where the map has it downwards.
     *
     * @param isVDown whether v of the mesh before runs downwards
     */
    public TriangleMesh mapped(TriangleMesh mesh, boolean isVDown) {
        if (!mesh.hasUv()) {
            return mesh;
        }
        float[] uv = new float[2 * mesh.vertices()];
        for (int i = 0; i < mesh.vertices(); i++) {
            double u = mesh.uv(i, 0);
            double v = isVDown ? mesh.uv(i, 1) : 1 - mesh.uv(i, 1);
            uv[2 * i] = (float) u(u, v);
            uv[2 * i + 1] = (float) (1 - v(u, v));
        }
        return mesh.withUv(uv);
    }
}
