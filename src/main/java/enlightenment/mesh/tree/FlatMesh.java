package enlightenment.mesh.tree;

import enlightenment.mesh.TriangleMesh;
import enlightenment.mesh.data.VertexArrays;

/**
 * A mesh with its hierarchy as plain arrays, for code on another device that searches it as {@link MeshRay} does. No array is to be changed.
 *
 * @param floats x, y and z of each vertex, or null if they are doubles
 * @param doubles x, y and z of each vertex, or null if they are floats
 * @param corners three vertices of each triangle
 * @param normals of each vertex, or null
 * @param uv texture coordinates of each vertex, or null
 * @param numbers the least and the greatest coordinates, what the hierarchy's coordinates are multiplied by, its reach, and the largest
 *     coordinate
 * @param boxes of the hierarchy, see {@link enlightenment.bvh.FloatSlabs}
 * @param children links of the hierarchy, see {@link enlightenment.bvh.Nodes}
 * @param order triangles in the order of its leaves
 */
public record FlatMesh(
        float[] floats,
        double[] doubles,
        int[] corners,
        float[] normals,
        float[] uv,
        double[] numbers,
        float[] boxes,
        int[] children,
        int[] order) {
    /** The form of a mesh. */
    public static FlatMesh of(TriangleMesh mesh) {
        VertexArrays arrays = mesh.data().vertices;
        TriangleTree tree = TriangleTree.of(mesh);
        double[] numbers = new double[9];
        System.arraycopy(tree.low, 0, numbers, 0, 3);
        System.arraycopy(tree.high, 0, numbers, 3, 3);
        numbers[6] = tree.unit;
        numbers[7] = tree.reach;
        numbers[8] = mesh.maxAbs();
        return new FlatMesh(
                arrays.floats,
                arrays.doubles,
                mesh.data().indices,
                arrays.normals,
                arrays.uv,
                numbers,
                tree.boxes,
                tree.child,
                tree.order);
    }
}
