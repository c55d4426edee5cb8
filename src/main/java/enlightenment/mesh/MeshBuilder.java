package enlightenment.mesh;

import enlightenment.mesh.data.VertexArrays;
import java.util.Arrays;

/**
 * Builds a mesh of vertices and triangles that are added one by one. Not safe for several threads.
 *
 * <p>Either all vertices have a normal, or none; the same holds for texture coordinates.
 *
 */
public final class MeshBuilder {
    private Floats floats = new Floats(0);

    /** The coordinates from when one is no float on; null before. */
    private double[] doubles;

    /** How many coordinates there are. */
    private int numbers;

    private Ints indices = new Ints(0);
    private Floats normals = new Floats(0);
    private Floats uv = new Floats(0);

    /** An empty mesh. */
    public MeshBuilder() {}

    /**
     * Adds a vertex.
     *
     * @return its number, counted from 0
     */
    public int vertex(double x, double y, double z) {
        if (doubles == null && !((float) x == x && (float) y == y && (float) z == z)) {
            becomeLong();
        }
        coordinate(x);
        coordinate(y);
        coordinate(z);
        return numbers / 3 - 1;
    }

    private void coordinate(double v) {
        if (doubles == null) {
            floats.add((float) v);
        } else {
            if (numbers == doubles.length) {
                doubles = Arrays.copyOf(doubles, Floats.larger(numbers));
            }
            doubles[numbers] = v;
        }
        numbers++;
    }

    private void becomeLong() {
        doubles = new double[numbers];
        for (int i = 0; i < numbers; i++) {
            doubles[i] = floats.get(i);
        }
        floats = new Floats(0);
    }

    /** Gives the next vertex without a normal its normal, of any length. */
    public void normal(double x, double y, double z) {
        normals.add((float) x);
        normals.add((float) y);
        normals.add((float) z);
    }

    /** Gives the next vertex without texture coordinates its own: u to the right, v upwards. */
    public void uv(double u, double v) {
        uv.add((float) u);
        uv.add((float) v);
    }

    /** Adds a triangle by the numbers of its vertices, counterclockwise as seen from outside; vertices may be added later. */
    public void triangle(int a, int b, int c) {
        indices.add(a);
        indices.add(b);
        indices.add(c);
    }

    /** Adds triangles, whose vertices are counted from one of those here. */
    void triangles(int[] some, int first) {
        for (int v : some) {
            indices.add(first + v);
        }
    }

    /** The number of vertices so far. */
    public int vertices() {
        return numbers / 3;
    }

    /** The number of triangles so far. */
    public int triangles() {
        return indices.size() / 3;
    }

    /**
     * The mesh. The builder is empty after it.
     *
     * @throws enlightenment.math.InvalidValueException as of {@link TriangleMesh#of(float[], int[])}, {@link TriangleMesh#withNormals} and
     *     {@link TriangleMesh#withUv}
     */
    public TriangleMesh build() {
        VertexArrays vertices = new VertexArrays(
                doubles == null ? floats.toArray() : null,
                doubles == null ? null : Arrays.copyOf(doubles, numbers),
                all(normals),
                all(uv));
        TriangleMesh mesh = new TriangleMesh(vertices, indices.toArray());
        floats = new Floats(0);
        doubles = null;
        numbers = 0;
        indices = new Ints(0);
        normals = new Floats(0);
        uv = new Floats(0);
        return mesh;
    }

    private static float[] all(Floats values) {
        return values.size() == 0 ? null : values.toArray();
    }
}
