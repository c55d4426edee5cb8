package enlightenment.mesh;

import enlightenment.check.Check;
import enlightenment.frame.Bounds;
import enlightenment.math.Vec3;
import enlightenment.mesh.data.MeshData;
import enlightenment.mesh.data.VertexArrays;
import java.util.Optional;

/**
 * A triangle mesh: triangles that share vertices, in coordinates of their own (object space). A triangle's geometric normal, (b − a) × (c − a),
 * points to its outside; a mesh is seen from both sides. Vertices may have a normal, by which surfaces are shaded as if they were smooth, and
 * texture coordinates, u to the right and v upwards. Immutable; equal meshes have equal numbers.
 *
 * <p>Coordinates are kept as floats where each is one, else as doubles. Triangles without an area are left out, and counted: files are full of
 * them.
 *
 */
public final class TriangleMesh extends MeshStore {
    /** Coordinates beyond this have squares that doubles cannot multiply; a transform makes meshes larger. */
    private static final double LARGEST = 1e30;

    private final Bounds bounds;
    private volatile String digest;
    private volatile OpenEdges openEdges;
    private volatile double volume = Double.NaN;

    /** This mesh with its front outside; null until it is asked for. */
    private volatile TriangleMesh outwards;

    /** Takes the arrays as they are. */
    TriangleMesh(VertexArrays arrays, int[] indices) {
        super(checked(arrays, indices));
        Check.that(data().indices.length > 0, "indices", "must hold at least one triangle with an area");
        bounds = boundsOf(this);
        double size = bounds.maxAbs();
        Check.that(
                size <= LARGEST && size >= 1 / LARGEST,
                "positions",
                "must have a largest coordinate between 1e-30 and 1e30, not " + size);
    }

    private TriangleMesh(TriangleMesh of, VertexArrays arrays, int[] indices) {
        super(new MeshData(arrays, indices, of.data().withoutArea));
        bounds = of.bounds;
    }

    private static MeshData checked(VertexArrays arrays, int[] indices) {
        check(indices, arrays.size());
        FlatTriangles flat = new FlatTriangles(arrays, indices);
        return new MeshData(arrays, flat.cornersOfOthers(), flat.corners());
    }

    private static void check(int[] all, int vertices) {
        Check.that(all.length % 3 == 0, "indices", "must be three for each triangle, not " + all.length + " in all");
        for (int i = 0; i < all.length; i++) {
            int v = all[i];
            if (v < 0 || v >= vertices) {
                Check.that(
                        false,
                        "indices",
                        "triangle " + i / 3 + " has the vertex " + v + "; there are " + vertices + " from 0");
            }
        }
    }

    /**
     * The mesh of these triangles; the arrays are copied.
     *
     * @param positions x, y, z of each vertex, finite
     * @param indices three vertices of each triangle, counted from 0
     * @throws enlightenment.math.InvalidValueException (key {@code positions} or {@code indices}) for a coordinate that is not finite, an
     *     index that is out of range, an incomplete vertex or triangle, or if no triangle has an area
     */
    public static TriangleMesh of(float[] positions, int[] indices) {
        return new TriangleMesh(new VertexArrays(positions.clone(), null, null, null), indices.clone());
    }

    /** {@link #of(float[], int[])} with coordinates of twice the precision. */
    public static TriangleMesh of(double[] positions, int[] indices) {
        return new TriangleMesh(VertexArrays.of(positions.clone(), null, null), indices.clone());
    }

    /**
     * This mesh with a normal for each vertex.
     *
     * @param values x, y, z for each vertex, of any length; the zero vector has no direction: there the geometric normal counts
     * @throws enlightenment.math.InvalidValueException (key {@code normals}) unless there is a finite one for each vertex
     */
    public TriangleMesh withNormals(float[] values) {
        return new TriangleMesh(this, arrays().withNormals(values.clone()), data().indices);
    }

    /** This mesh without normals of vertices: each triangle is flat. */
    public TriangleMesh flat() {
        return hasNormals() ? new TriangleMesh(this, arrays().withNormals(null), data().indices) : this;
    }

    /** This mesh, smooth everywhere: the normal of a vertex is the mean of those of the triangles around it, weighted by their angles. */
    public TriangleMesh smooth() {
        return smooth(180);
    }

    /**
     * This mesh, smooth but for its edges: at a vertex, normals of triangles that differ from a triangle's own by more than an angle do not count for it.
     * Vertices are split where triangles disagree. Vertices in the same place count as one.
     *
     * @param crease the angle in degrees, 0..180
     */
    public TriangleMesh smooth(double crease) {
        Check.range("crease", crease, 0, 180);
        return SmoothNormals.of(this, crease);
    }

    /**
     * This mesh with texture coordinates for each vertex.
     *
     * @param values u and v for each vertex
     * @throws enlightenment.math.InvalidValueException (key {@code uv}) unless there are two finite numbers for each vertex
     */
    public TriangleMesh withUv(float[] values) {
        return new TriangleMesh(this, arrays().withUv(values.clone()), data().indices);
    }

    /**
     * This mesh with its front where its back is: the corners of each triangle in the opposite order, normals of vertices negated. Texture coordinates
     * stay.
     */
    public TriangleMesh turned() {
        int[] indices = data().indices;
        int[] order = indices.clone();
        for (int i = 0; i < order.length; i += 3) {
            order[i + 1] = indices[i + 2];
            order[i + 2] = indices[i + 1];
        }
        return new TriangleMesh(this, arrays().withNegatedNormals(), order);
    }

    /** The number of vertices. */
    public int vertices() {
        return arrays().size();
    }

    /** The number of triangles, at least 1, without those that were left out. */
    public int triangles() {
        return data().indices.length / 3;
    }

    /** How many triangles had no area and were left out. */
    public int dropped() {
        return data().withoutArea.length / 3;
    }

    /** The vertex at a corner of a triangle; corner 0, 1 or 2. */
    public int vertex(int triangle, int corner) {
        return data().indices[3 * triangle + corner];
    }

    /** A coordinate of a vertex; axis 0, 1 or 2. */
    public double coordinate(int vertex, int axis) {
        return arrays().coordinate(vertex, axis);
    }

    /** The position of a vertex. */
    public Vec3 position(int vertex) {
        return new Vec3(coordinate(vertex, 0), coordinate(vertex, 1), coordinate(vertex, 2));
    }

    /** Whether each coordinate is a float. */
    public boolean isOfFloats() {
        return arrays().floats != null;
    }

    /** Whether vertices have normals. */
    public boolean hasNormals() {
        return arrays().normals != null;
    }

    /** Whether vertices have texture coordinates. */
    public boolean hasUv() {
        return arrays().uv != null;
    }

    /** The normal of a vertex, as it was given: of any length. */
    public Vec3 normal(int vertex) {
        float[] n = arrays().normals;
        return new Vec3(n[3 * vertex], n[3 * vertex + 1], n[3 * vertex + 2]);
    }

    /** A texture coordinate of a vertex: 0 for u, 1 for v. */
    public double uv(int vertex, int which) {
        return arrays().uv[2 * vertex + which];
    }

    /** The geometric normal of a triangle, as long as twice its area: the sum of these over a closed mesh is 0. */
    public Vec3 areaNormal(int triangle) {
        double[] n = new double[3];
        data().normal(triangle, n);
        return new Vec3(n[0], n[1], n[2]);
    }

    /**
     * This mesh with its front outside: {@link #turned} if it is closed and its triangles face inwards, that is, if it encloses a negative volume;
     * else the mesh itself. Of a mesh with cavities the outer shell decides, as the larger one.
     */
    public TriangleMesh outwards() {
        TriangleMesh known = outwards;
        if (known == null) {
            known = isClosed() && signedVolume() < 0 ? turned() : this;
            outwards = known;
        }
        return known;
    }

    /** The volume that a closed mesh encloses, by the divergence theorem. */
    public double volume() {
        return Math.abs(signedVolume());
    }

    /** The volume, negative if its triangles face inwards. */
    private double signedVolume() {
        double known = volume;
        if (Double.isNaN(known)) {
            Vec3 middle = min().plus(max()).times(0.5);
            double sum = 0;
            for (int t = 0; t < triangles(); t++) {
                sum += areaNormal(t).dot(position(vertex(t, 0)).minus(middle));
            }
            known = sum / 6;
            volume = known;
        }
        return known;
    }

    /** The number of edges that keep the mesh from being closed, see {@link #isClosed}. */
    public long openEdges() {
        return open().count;
    }

    private OpenEdges open() {
        OpenEdges edges = openEdges;
        if (edges == null) {
            edges = new OpenEdges(this);
            openEdges = edges;
        }
        return edges;
    }

    /**
     * This mesh with its holes closed by triangles over their rims, which are edges; empty if they would have more than a share of its area, if rims
     * have a vertex in common, or if it has no holes.
     *
     * @param share of the area of the mesh, 0..1
     */
    public Optional<TriangleMesh> withoutHoles(double share) {
        return Holes.closed(this, open(), share);
    }

    /**
     * Whether it encloses a volume: along each edge run as many triangles one way as the other way. Vertices in the same place count as one.
     * Whether the mesh intersects itself is not looked at.
     */
    public boolean isClosed() {
        return openEdges() == 0;
    }

    /** The least coordinates of any triangle. */
    public Vec3 min() {
        return bounds().min();
    }

    /** The greatest coordinates of any triangle. */
    public Vec3 max() {
        return bounds().max();
    }

    /** The largest absolute coordinate of any triangle. */
    public double maxAbs() {
        return bounds().maxAbs();
    }

    /** The box around all triangles. */
    Bounds bounds() {
        return bounds;
    }

    private static Bounds boundsOf(TriangleMesh mesh) {
        double[] low = {Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY};
        double[] high = {Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY};
        for (int v : mesh.data().indices) {
            for (int axis = 0; axis < 3; axis++) {
                double c = mesh.coordinate(v, axis);
                low[axis] = Math.min(low[axis], c);
                high[axis] = Math.max(high[axis], c);
            }
        }
        return new Bounds(new Vec3(low[0], low[1], low[2]), new Vec3(high[0], high[1], high[2]));
    }

    /** The bytes that its arrays take. */
    public long bytes() {
        return data().bytes();
    }

    /** The vertices themselves, for reading only. */
    private VertexArrays arrays() {
        return data().vertices;
    }

    /** A hash of all its numbers: 64 hexadecimal digits, equal for equal meshes and, as far as anybody knows, for no others. */
    public String digest() {
        String known = digest;
        if (known == null) {
            known = MeshDigest.of(arrays(), data().indices);
            digest = known;
        }
        return known;
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof TriangleMesh o
                && (o == this || triangles() == o.triangles() && digest().equals(o.digest()));
    }

    @Override
    public int hashCode() {
        return 31 * vertices() + triangles();
    }

    @Override
    public String toString() {
        return "TriangleMesh[" + triangles() + " triangles, " + vertices() + " vertices]";
    }
}
