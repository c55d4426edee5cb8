package enlightenment.importer.pbrt;

import enlightenment.math.Vec3;
import enlightenment.mesh.MeshBuilder;
import enlightenment.mesh.TriangleMesh;

/**
 * pbrt's quadrics and bilinear patches as triangles, with their normals and texture coordinates (u around, v upwards or inwards). Triangles wind
 * counterclockwise around the normals.
 */
final class Tessellation {
    /** Steps around a full circle. */
    private static final int AROUND = 128;

    /** Steps from pole to pole. */
    private static final int RINGS = 64;

    /** Steps along each side of a curved patch. */
    private static final int PATCH = 8;

    private Tessellation() {}

    /** A point of a surface with its normal, for u and v in 0..1. */
    private interface Surface {
        void add(MeshBuilder mesh, double u, double v, Turn turn);
    }

    /** Cosine and sine of an angle around the axis. */
    private record Turn(double cos, double sin) {
        static Turn of(int i, int steps, double phiMax) {
            if (i == 0 || i == steps && phiMax == 360) {
                return new Turn(1, 0);
            }
            double phi = StrictMath.toRadians(phiMax) * i / steps;
            return new Turn(StrictMath.cos(phi), StrictMath.sin(phi));
        }
    }

    /** A part of a sphere about the origin, from zMin to zMax, around by phiMax degrees. */
    static TriangleMesh sphere(double radius, double zMin, double zMax, double phiMax) {
        double from = angle(radius, zMin);
        double to = angle(radius, zMax);
        return grid(around(phiMax), RINGS, phiMax, (mesh, u, v, turn) -> {
            double theta = from + v * (to - from);
            boolean isPole = v == 0 && zMin <= -radius || v == 1 && zMax >= radius;
            double rho = isPole ? 0 : StrictMath.sin(theta);
            double z = isPole ? (v == 0 ? -1 : 1) : StrictMath.cos(theta);
            mesh.vertex(radius * rho * turn.cos, radius * rho * turn.sin, radius * z);
            mesh.normal(rho * turn.cos, rho * turn.sin, z);
        });
    }

    private static double angle(double radius, double z) {
        return StrictMath.acos(Math.min(1, Math.max(-1, z / radius)));
    }

    /** A part of a cylinder about the z axis. */
    static TriangleMesh cylinder(double radius, double zMin, double zMax, double phiMax) {
        return grid(around(phiMax), 1, phiMax, (mesh, u, v, turn) -> {
            mesh.vertex(radius * turn.cos, radius * turn.sin, v == 0 ? zMin : zMax);
            mesh.normal(turn.cos, turn.sin, 0);
        });
    }

    /** A part of a disk about the z axis that faces +z, with or without a hole; v is 0 at its edge. */
    static TriangleMesh disk(double height, double radius, double innerRadius, double phiMax) {
        return grid(around(phiMax), 1, phiMax, (mesh, u, v, turn) -> {
            double r = v == 0 ? radius : innerRadius;
            mesh.vertex(r * turn.cos, r * turn.sin, height);
            mesh.normal(0, 0, 1);
        });
    }

    private static int around(double phiMax) {
        return Math.max(2, (int) StrictMath.ceil(AROUND * phiMax / 360));
    }

    private static TriangleMesh grid(int columns, int rows, double phiMax, Surface surface) {
        MeshBuilder mesh = new MeshBuilder();
        for (int j = 0; j <= rows; j++) {
            for (int i = 0; i <= columns; i++) {
                double u = (double) i / columns;
                double v = (double) j / rows;
                surface.add(mesh, u, v, Turn.of(i, columns, phiMax));
                mesh.uv(u, v);
            }
        }
        triangles(mesh, 0, columns, rows);
        return mesh.build();
    }

    private static void triangles(MeshBuilder mesh, int first, int columns, int rows) {
        for (int j = 0; j < rows; j++) {
            for (int i = 0; i < columns; i++) {
                int a = first + j * (columns + 1) + i;
                int b = a + columns + 1;
                mesh.triangle(a, a + 1, b + 1);
                mesh.triangle(a, b + 1, b);
            }
        }
    }

    /**
     * Adds a bilinear patch.
     *
     * @param p the corners 00, 10, 01, 11
     * @param uv their texture coordinates, u and v of each
     * @param n their normals, or null for those of the patch
     * @return whether it is curved
     */
    static boolean addPatch(MeshBuilder mesh, Vec3[] p, double[] uv, Vec3[] n) {
        Vec3 twist = p[3].minus(p[2]).minus(p[1].minus(p[0]));
        boolean isCurved = twist.dot(p[1].minus(p[0]).cross(p[2].minus(p[0]))) != 0;
        int steps = twist.maxAbs() == 0 ? 1 : PATCH;
        int first = mesh.vertices();
        for (int j = 0; j <= steps; j++) {
            for (int i = 0; i <= steps; i++) {
                double s = (double) i / steps;
                double t = (double) j / steps;
                Vec3 at = blend(p, s, t);
                mesh.vertex(at.x(), at.y(), at.z());
                Vec3 normal = n == null ? patchNormal(p, s, t) : blend(n, s, t);
                mesh.normal(normal.x(), normal.y(), normal.z());
                mesh.uv(blend(uv, 0, s, t), blend(uv, 1, s, t));
            }
        }
        triangles(mesh, first, steps, steps);
        return isCurved;
    }

    private static Vec3 patchNormal(Vec3[] p, double s, double t) {
        Vec3 du = p[1].minus(p[0]).times(1 - t).plus(p[3].minus(p[2]).times(t));
        Vec3 dv = p[2].minus(p[0]).times(1 - s).plus(p[3].minus(p[1]).times(s));
        Vec3 n = du.cross(dv);
        return n.length() > 0 ? n.normalized() : Vec3.ZERO;
    }

    private static Vec3 blend(Vec3[] p, double s, double t) {
        return p[0].times((1 - s) * (1 - t))
                .plus(p[1].times(s * (1 - t)))
                .plus(p[2].times((1 - s) * t))
                .plus(p[3].times(s * t));
    }

    private static double blend(double[] uv, int which, double s, double t) {
        return uv[which] * (1 - s) * (1 - t)
                + uv[2 + which] * s * (1 - t)
                + uv[4 + which] * (1 - s) * t
                + uv[6 + which] * s * t;
    }
}
