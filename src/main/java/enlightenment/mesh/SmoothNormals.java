package enlightenment.mesh;

import enlightenment.math.Vec3;
import java.util.Arrays;

/** Makes normals of vertices from those of the triangles around them. */
final class SmoothNormals {
    private final TriangleMesh mesh;
    private final double cosine;

    /** By triangle: its unit normal. */
    private final float[] faces;

    /** By place of vertices: where its corners begin in {@link #corners}. */
    private final int[] start;

    /** Corners 3·triangle + k, by place. */
    private final int[] corners;

    private final int[] place;

    /** By corner: the angle of its triangle there, in radians. Each counts for all corners of its place. */
    private final double[] angles;

    private SmoothNormals(TriangleMesh mesh, double crease) {
        this.mesh = mesh;
        cosine = crease >= 180 ? -2 : StrictMath.cos(Math.toRadians(crease));
        place = new Welding(mesh).first;
        int n = mesh.triangles();
        faces = new float[3 * n];
        for (int t = 0; t < n; t++) {
            Vec3 normal = mesh.areaNormal(t);
            Vec3 unit = normal.scaledBy(-normal.exponent()).normalized();
            faces[3 * t] = (float) unit.x();
            faces[3 * t + 1] = (float) unit.y();
            faces[3 * t + 2] = (float) unit.z();
        }
        start = new int[mesh.vertices() + 1];
        for (int i = 0; i < 3 * n; i++) {
            start[place[mesh.vertex(i / 3, i % 3)] + 1]++;
        }
        for (int v = 0; v < mesh.vertices(); v++) {
            start[v + 1] += start[v];
        }
        corners = new int[3 * n];
        int[] next = start.clone();
        for (int i = 0; i < 3 * n; i++) {
            corners[next[place[mesh.vertex(i / 3, i % 3)]]++] = i;
        }
        angles = new double[3 * n];
        Arrays.setAll(angles, this::angle);
    }

    /** The mesh with the normals of its triangles' corners; vertices are split where corners of one vertex disagree. */
    static TriangleMesh of(TriangleMesh mesh, double crease) {
        return new SmoothNormals(mesh, crease).split();
    }

    private TriangleMesh split() {
        int n = mesh.triangles();
        Vertices all = new Vertices(mesh);
        int[] indices = new int[3 * n];
        double[] sum = new double[3];
        for (int i = 0; i < 3 * n; i++) {
            sum(i, sum);
            double s = 1 / Math.sqrt(sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2]);
            boolean isDirection = s < Double.POSITIVE_INFINITY;
            float x = isDirection ? (float) (sum[0] * s) : 0;
            float y = isDirection ? (float) (sum[1] * s) : 0;
            float z = isDirection ? (float) (sum[2] * s) : 0;
            indices[i] = all.with(mesh.vertex(i / 3, i % 3), x, y, z);
        }
        return all.mesh(indices);
    }

    /** Adds up the normals that count for a corner, in the order of the triangles. */
    private void sum(int corner, double[] sum) {
        Arrays.fill(sum, 0);
        int own = 3 * (corner / 3);
        int p = place[mesh.vertex(corner / 3, corner % 3)];
        for (int k = start[p]; k < start[p + 1]; k++) {
            int other = 3 * (corners[k] / 3);
            double c = (double) faces[own] * faces[other]
                    + (double) faces[own + 1] * faces[other + 1]
                    + (double) faces[own + 2] * faces[other + 2];
            if (c >= cosine || other == own) {
                double angle = angles[corners[k]];
                for (int axis = 0; axis < 3; axis++) {
                    sum[axis] += angle * faces[other + axis];
                }
            }
        }
    }

    /** The angle of a triangle at a corner. */
    private double angle(int corner) {
        int t = corner / 3;
        int k = corner % 3;
        Vec3 a = mesh.position(mesh.vertex(t, k));
        Vec3 p = mesh.position(mesh.vertex(t, (k + 1) % 3)).minus(a);
        Vec3 q = mesh.position(mesh.vertex(t, (k + 2) % 3)).minus(a);
        p = p.scaledBy(-p.exponent());
        q = q.scaledBy(-q.exponent());
        return StrictMath.atan2(p.cross(q).length(), p.dot(q));
    }

    /** The vertices of the new mesh: one for each vertex of the old one and each of its normals. */
    private static final class Vertices {
        private final TriangleMesh mesh;
        private int[] old;
        private float[] normals;

        /** By new vertex: the next one of the same old vertex, or -1. */
        private int[] next;

        private int size;

        Vertices(TriangleMesh mesh) {
            this.mesh = mesh;
            size = mesh.vertices();
            old = new int[size];
            next = new int[size];
            normals = new float[3 * size];
            Arrays.fill(normals, Float.NaN);
            Arrays.fill(next, -1);
            for (int v = 0; v < size; v++) {
                old[v] = v;
            }
        }

        int with(int vertex, float x, float y, float z) {
            if (Float.isNaN(normals[3 * vertex])) {
                return set(vertex, x, y, z);
            }
            int v = vertex;
            while (true) {
                if (normals[3 * v] == x && normals[3 * v + 1] == y && normals[3 * v + 2] == z) {
                    return v;
                }
                if (next[v] < 0) {
                    break;
                }
                v = next[v];
            }
            if (size == old.length) {
                int more = size + size / 2 + 1;
                old = Arrays.copyOf(old, more);
                next = Arrays.copyOf(next, more);
                normals = Arrays.copyOf(normals, 3 * more);
            }
            next[v] = size;
            next[size] = -1;
            old[size] = vertex;
            return set(size++, x, y, z);
        }

        private int set(int v, float x, float y, float z) {
            normals[3 * v] = x;
            normals[3 * v + 1] = y;
            normals[3 * v + 2] = z;
            return v;
        }

        TriangleMesh mesh(int[] indices) {
            float[] n = Arrays.copyOf(normals, 3 * size);
            for (int i = 0; i < n.length; i++) {
                n[i] = Float.isNaN(n[i]) ? 0 : n[i]; // a vertex that no triangle has
            }
            int[] flat = mesh.data().withoutArea;
            int[] all = Arrays.copyOf(indices, indices.length + flat.length);
            System.arraycopy(flat, 0, all, indices.length, flat.length);
            return new TriangleMesh(mesh.data().vertices.copies(Arrays.copyOf(old, size), n), all);
        }
    }
}
