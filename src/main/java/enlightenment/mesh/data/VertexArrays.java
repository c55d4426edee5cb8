package enlightenment.mesh.data;

import enlightenment.check.Check;
import enlightenment.numeric.Products;

/**
 * What a mesh knows of its vertices: three coordinates of each, as floats or as doubles, and, where it has them, normals and texture coordinates. The arrays
 * are those that were given, and are only read.
 */
public final class VertexArrays {
    /** The coordinates, one after the other, if all of them are floats; else null. */
    public final float[] floats;

    /** The coordinates as doubles if they are no floats; else null. */
    public final double[] doubles;

    /** Three numbers for each vertex; null if there are no normals. */
    public final float[] normals;

    /** Two numbers for each vertex; null if there are no texture coordinates. */
    public final float[] uv;

    /** @throws enlightenment.math.InvalidValueException for numbers that are not finite, or for too many or too few */
    public VertexArrays(float[] floats, double[] doubles, float[] normals, float[] uv) {
        this.floats = floats;
        this.doubles = doubles;
        this.normals = normals;
        this.uv = uv;
        int n = numbers();
        Check.that(n % 3 == 0, "positions", "must be three numbers for each vertex, not " + n + " in all");
        for (int i = 0; i < n; i++) {
            double v = number(i);
            if (!Double.isFinite(v)) {
                Check.that(false, "positions", "vertex " + i / 3 + " has a coordinate that is not finite: " + v);
            }
        }
        check(normals, 3, "normals");
        check(uv, 2, "uv");
    }

    private VertexArrays(VertexArrays of, float[] normals, float[] uv) {
        floats = of.floats;
        doubles = of.doubles;
        this.normals = normals;
        this.uv = uv;
        check(normals, 3, "normals");
        check(uv, 2, "uv");
    }

    /** These coordinates, as floats if each of them is one. */
    public static VertexArrays of(double[] positions, float[] normals, float[] uv) {
        float[] floats = new float[positions.length];
        for (int i = 0; i < floats.length; i++) {
            floats[i] = (float) positions[i];
            if (floats[i] != positions[i]) {
                return new VertexArrays(null, positions, normals, uv);
            }
        }
        return new VertexArrays(floats, null, normals, uv);
    }

    /** These coordinates with other normals, or none. */
    public VertexArrays withNormals(float[] values) {
        return new VertexArrays(this, values, uv);
    }

    /** These coordinates with normals, if there are any, in opposite directions. */
    public VertexArrays withNegatedNormals() {
        float[] opposite = normals == null ? null : normals.clone();
        for (int i = 0; opposite != null && i < opposite.length; i++) {
            opposite[i] = 0 - opposite[i];
        }
        return withNormals(opposite);
    }

    /** These coordinates with other texture coordinates. */
    public VertexArrays withUv(float[] values) {
        return new VertexArrays(this, normals, values);
    }

    private void check(float[] attribute, int each, String key) {
        if (attribute == null) {
            return;
        }
        Check.that(
                attribute.length == each * size(),
                key,
                "must be " + each + " numbers for each of " + size() + " vertices, not " + attribute.length);
        for (int i = 0; i < attribute.length; i++) {
            if (!Float.isFinite(attribute[i])) {
                Check.that(false, key, "vertex " + i / each + " has a number that is not finite: " + attribute[i]);
            }
        }
    }

    /** The number of coordinates. */
    public int numbers() {
        return floats == null ? doubles.length : floats.length;
    }

    /** Coordinate i % 3 of vertex i / 3. */
    public double number(int i) {
        return floats == null ? doubles[i] : floats[i];
    }

    /** The number of vertices. */
    public int size() {
        return numbers() / 3;
    }

    public double coordinate(int vertex, int axis) {
        return number(3 * vertex + axis);
    }

    /** Whether two vertices are in the same place. */
    public boolean areInOnePlace(int v, int w) {
        return v == w
                || coordinate(v, 0) == coordinate(w, 0)
                        && coordinate(v, 1) == coordinate(w, 1)
                        && coordinate(v, 2) == coordinate(w, 2);
    }

    /** Writes the geometric normal of a triangle, as long as twice its area; whether it has a length. */
    public boolean normal(int a, int b, int c, double[] out) {
        double ux = coordinate(b, 0) - coordinate(a, 0);
        double uy = coordinate(b, 1) - coordinate(a, 1);
        double uz = coordinate(b, 2) - coordinate(a, 2);
        double vx = coordinate(c, 0) - coordinate(a, 0);
        double vy = coordinate(c, 1) - coordinate(a, 1);
        double vz = coordinate(c, 2) - coordinate(a, 2);
        out[0] = Products.difference(uy, vz, uz, vy);
        out[1] = Products.difference(uz, vx, ux, vz);
        out[2] = Products.difference(ux, vy, uy, vx);
        double size = Math.abs(out[0]) + Math.abs(out[1]) + Math.abs(out[2]);
        return size > 0 && size < Double.POSITIVE_INFINITY;
    }

    /**
     * Copies of vertices, with other normals.
     *
     * @param from by copy: the vertex that it is of
     * @param values by copy: its normal
     */
    public VertexArrays copies(int[] from, float[] values) {
        float[] p = floats == null ? null : picked(floats, 3, from);
        double[] q = floats == null ? new double[3 * from.length] : null;
        for (int i = 0; q != null && i < q.length; i++) {
            q[i] = doubles[3 * from[i / 3] + i % 3];
        }
        return new VertexArrays(p, q, values, uv == null ? null : picked(uv, 2, from));
    }

    private static float[] picked(float[] values, int each, int[] from) {
        float[] some = new float[each * from.length];
        for (int i = 0; i < some.length; i++) {
            some[i] = values[each * from[i / each] + i % each];
        }
        return some;
    }

    /** The bytes that the arrays take. */
    long bytes() {
        return (floats == null ? 8L * doubles.length : 4L * floats.length)
                + 4L * ((normals == null ? 0 : normals.length) + (uv == null ? 0 : uv.length));
    }
}
