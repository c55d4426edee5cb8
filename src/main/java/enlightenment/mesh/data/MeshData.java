package enlightenment.mesh.data;

/**
 * What a mesh is made of, for packages that are not exported: its arrays, for reading only, and what was made of them and is kept with the mesh.
 * All methods may be called by several threads at once.
 */
public final class MeshData {
    /** The vertices. */
    public final VertexArrays vertices;

    /** Three vertices of each triangle that has an area. */
    public final int[] indices;

    /** Three vertices of each triangle that has none, and was left out. */
    public final int[] withoutArea;

    private volatile Object hierarchy;
    private volatile Object union;

    /** Takes the arrays as they are. */
    public MeshData(VertexArrays vertices, int[] indices, int[] withoutArea) {
        this.vertices = vertices;
        this.indices = indices;
        this.withoutArea = withoutArea;
    }

    /** Writes the geometric normal of a triangle, as long as twice its area. */
    public void normal(int triangle, double[] out) {
        int at = 3 * triangle;
        vertices.normal(indices[at], indices[at + 1], indices[at + 2], out);
    }

    /** The hierarchy of the triangles; null until it is kept. */
    public Object hierarchy() {
        return hierarchy;
    }

    /** Keeps the hierarchy of the triangles, for all instances of the mesh. */
    public void keepHierarchy(Object made) {
        hierarchy = made;
    }

    /** What was made of this mesh and others; null until it is kept. */
    public Object union() {
        return union;
    }

    /** Keeps what was made of this mesh and others, in place of what was made before. */
    public void keepUnion(Object made) {
        union = made;
    }

    /** The bytes that the arrays of triangles and vertices take. */
    public long bytes() {
        return 4L * indices.length + vertices.bytes();
    }
}
