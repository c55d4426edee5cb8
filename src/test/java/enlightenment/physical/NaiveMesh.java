package enlightenment.physical;

import enlightenment.geometry.Mesh;
import enlightenment.math.Vec3;
import enlightenment.mesh.TriangleMesh;

/** All triangles of a mesh, asked one after the other: a closed mesh, moved, turned and scaled alike in all directions. */
final class NaiveMesh extends NaiveShape {
    private final Flat[] triangles;
    private final Vec3[][] normals;
    private final Vec3 center;
    private final double radius;

    NaiveMesh(Mesh shape) {
        TriangleMesh mesh = shape.triangles();
        triangles = new Flat[mesh.triangles()];
        normals = new Vec3[triangles.length][3];
        Vec3 sum = Vec3.ZERO;
        double far = 0;
        for (int t = 0; t < triangles.length; t++) {
            Vec3[] v = new Vec3[3];
            for (int k = 0; k < 3; k++) {
                v[k] = at(shape.transform().apply(mesh.position(mesh.vertex(t, k))));
                Vec3 n = mesh.hasNormals()
                        ? mesh.normal(mesh.vertex(t, k))
                        : mesh.areaNormal(t).normalized();
                Vec3 tip = mesh.position(mesh.vertex(t, k)).plus(n);
                normals[t][k] = at(shape.transform().apply(tip)).minus(v[k]).normalized();
            }
            triangles[t] = new Flat(v[0], v[1], v[2], true);
            sum = sum.plus(v[0]);
        }
        center = sum.times(1.0 / triangles.length);
        for (int v = 0; v < mesh.vertices(); v++) {
            far = Math.max(
                    far,
                    at(shape.transform().apply(mesh.position(v))).minus(center).length());
        }
        radius = 1.0001 * far;
    }

    @Override
    double hit(Vec3 o, Vec3 d, double from) {
        Vec3 m = center.minus(o);
        if (m.minus(d.times(m.dot(d) / d.dot(d))).length() > radius) {
            return NONE;
        }
        double best = NONE;
        for (Flat triangle : triangles) {
            best = Math.min(best, triangle.hit(o, d, from));
        }
        return best;
    }

    /** The triangle that a point lies on. */
    private int triangle(Vec3 p) {
        double best = NONE;
        int nearest = 0;
        for (int t = 0; t < triangles.length; t++) {
            double[] at = triangles[t].texture(p);
            double outside = Math.max(0, Math.max(Math.max(-at[0], -at[1]), at[0] + at[1] - 1));
            Vec3 foot = p.minus(triangles[t].mirrored(p)).times(0.5);
            if (foot.length() + outside < best) {
                best = foot.length() + outside;
                nearest = t;
            }
        }
        return nearest;
    }

    @Override
    Vec3 normal(Vec3 p) {
        return triangles[triangle(p)].normal(p);
    }

    @Override
    Vec3 shadingNormal(Vec3 p) {
        int t = triangle(p);
        double[] at = triangles[t].texture(p);
        return normals[t][0]
                .times(1 - at[0] - at[1])
                .plus(normals[t][1].times(at[0]))
                .plus(normals[t][2].times(at[1]))
                .normalized();
    }

    @Override
    boolean contains(Vec3 p) {
        int crossings = 0;
        for (Flat triangle : triangles) {
            crossings += triangle.hit(p, new Vec3(0.3, 0.5, 0.7), 0) < NONE ? 1 : 0;
        }
        return crossings % 2 == 1;
    }

    @Override
    double volume() {
        double sum = 0;
        for (Flat triangle : triangles) {
            sum += triangle.cone(center);
        }
        return sum;
    }
}
