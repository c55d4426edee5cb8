package enlightenment.mesh.tree;

/** Where the vertices of a mesh go, by an affine map; equal maps are equal. Immutable. */
public interface PlacedVertices {
    /** A coordinate of where a point of the mesh is; axis 0, 1 or 2. */
    double coordinate(int axis, double x, double y, double z);

    /** Whether triangles are seen from their other side there, unless their corners change their order. */
    boolean isMirror();
}
