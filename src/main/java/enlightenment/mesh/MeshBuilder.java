package enlightenment.mesh;

import enlightenment.check.Check;
import java.util.Arrays;

/**
 * Collects vertices and triangles of a mesh that is generated or read piece by piece. Not safe for several threads.
 *
 * <p>Either all vertices have a normal, or none; the same holds for texture coordinates.
 */
public final class MeshBuilder {
    private static final int LARGEST = Integer.MAX_VALUE - 64;

    private double[] positions = new double[0];
    private float[] floats = new float[3 * 64];
    private boolean isOfFloats = true;
    private int numbers;
    private int[] indices = new int[3 * 64];
    private int corners;
    private float[] normals = {};
    private int normalNumbers;
    private float[] uv = {};
    private int uvNumbers;

    /** An empty mesh. */
    public MeshBuilder() {}

    /**
     * Adds a vertex.
     *
     * @return its number, counted from 0
     */
    public int vertex(double x, double y, double z) {
        if (isOfFloats && !((float) x == x && (float) y == y && (float) z == z)) {
            becomeLong();
        }
        if (isOfFloats) {
            if (numbers + 3 > floats.length) {
                floats = Arrays.copyOf(floats, larger(floats.length));
            }
            floats[numbers] = (float) x;
            floats[numbers + 1] = (float) y;
            floats[numbers + 2] = (float) z;
        } else {
            if (numbers + 3 > positions.length) {
                positions = Arrays.copyOf(positions, larger(positions.length));
            }
            positions[numbers] = x;
            positions[numbers + 1] = y;
            positions[numbers + 2] = z;
        }
        numbers += 3;
        return numbers / 3 - 1;
    }

    private void becomeLong() {
        isOfFloats = false;
        positions = new double[floats.length];
        for (int i = 0; i < numbers; i++) {
            positions[i] = floats[i];
        }
        floats = new float[0];
    }

    /** Gives the next vertex without a normal its normal, of any length. */
    public void normal(double x, double y, double z) {
        if (normalNumbers + 3 > normals.length) {
            normals = Arrays.copyOf(normals, larger(normals.length));
        }
        normals[normalNumbers++] = (float) x;
        normals[normalNumbers++] = (float) y;
        normals[normalNumbers++] = (float) z;
    }

    /** Gives the next vertex without texture coordinates its own: u to the right, v upwards. */
    public void uv(double u, double v) {
        if (uvNumbers + 2 > uv.length) {
            uv = Arrays.copyOf(uv, larger(uv.length));
        }
        uv[uvNumbers++] = (float) u;
        uv[uvNumbers++] = (float) v;
    }

    /** Adds a triangle by the numbers of its vertices, which may be added later; from outside they run against the clock. */
    public void triangle(int a, int b, int c) {
        if (corners + 3 > indices.length) {
            indices = Arrays.copyOf(indices, larger(indices.length));
        }
        indices[corners++] = a;
        indices[corners++] = b;
        indices[corners++] = c;
    }

    /** Adds triangles, whose vertices are counted from one of those here. */
    void triangles(int[] some, int first) {
        for (int i = 0; i < some.length; i += 3) {
            triangle(first + some[i], first + some[i + 1], first + some[i + 2]);
        }
    }

    private static int larger(int length) {
        Check.that(length < LARGEST, "indices", "are more than one mesh can hold");
        return (int) Math.min(LARGEST, Math.max(192, length + (long) length / 2));
    }

    /** The number of vertices so far. */
    public int vertices() {
        return numbers / 3;
    }

    /** The number of triangles so far. */
    public int triangles() {
        return corners / 3;
    }

    /**
     * The mesh. The builder is empty after it.
     *
     * @throws enlightenment.math.InvalidValueException as of {@link TriangleMesh#of(float[], int[])}, {@link TriangleMesh#withNormals} and
     *     {@link TriangleMesh#withUv}
     */
    public TriangleMesh build() {
        float[] some = isOfFloats ? Arrays.copyOf(floats, numbers) : null;
        double[] longer = isOfFloats ? null : Arrays.copyOf(positions, numbers);
        floats = new float[3 * 64];
        positions = new double[0];
        int[] triangles = Arrays.copyOf(indices, corners);
        indices = new int[3 * 64];
        TriangleMesh mesh = new TriangleMesh(some, longer, triangles, all(normals, normalNumbers), all(uv, uvNumbers));
        isOfFloats = true;
        numbers = 0;
        corners = 0;
        normals = new float[0];
        normalNumbers = 0;
        uv = new float[0];
        uvNumbers = 0;
        return mesh;
    }

    private static float[] all(float[] values, int n) {
        return n == 0 ? null : Arrays.copyOf(values, n);
    }
}
