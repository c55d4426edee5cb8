package enlightenment.importer.mitsuba;

import enlightenment.importer.support.Affine;
import enlightenment.math.Vec3;
import enlightenment.mesh.TriangleMesh;

/**
 * What a texture does to texture coordinates before it looks colours up, with v downwards: (a u + b v + c, d u + e v + f). A value.
 */
record UvMap(double a, double b, double c, double d, double e, double f) {
    static final UvMap IDENTITY = new UvMap(1, 0, 0, 0, 1, 0);

    /** The map of a transform in three dimensions, whose z does not count. */
    static UvMap of(Affine m) {
        Vec3 x = m.x();
        Vec3 y = m.y();
        return new UvMap(x.x(), x.y(), m.offset().x(), y.x(), y.y(), m.offset().y());
    }

    /** Whether it only scales both coordinates by a factor above 0. */
    boolean isScale() {
        return b == 0 && c == 0 && d == 0 && f == 0 && a == e && a > 0;
    }

    /**
     * A mesh with mapped texture coordinates, which have v upwards before and after.
     *
     * @param isVDown whether v of the mesh before runs downwards
     */
    TriangleMesh mapped(TriangleMesh mesh, boolean isVDown) {
        if (!mesh.hasUv()) {
            return mesh;
        }
        float[] uv = new float[2 * mesh.vertices()];
        for (int i = 0; i < mesh.vertices(); i++) {
            double u = mesh.uv(i, 0);
            double v = isVDown ? mesh.uv(i, 1) : 1 - mesh.uv(i, 1);
            uv[2 * i] = (float) (a * u + b * v + c);
            uv[2 * i + 1] = (float) (1 - (d * u + e * v + f));
        }
        return mesh.withUv(uv);
    }
}
