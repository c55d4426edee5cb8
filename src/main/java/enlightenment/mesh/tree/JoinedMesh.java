package enlightenment.mesh.tree;

import enlightenment.mesh.TriangleMesh;
import enlightenment.mesh.data.VertexArrays;
import java.util.List;

/** Makes one mesh of several. All methods may be called by several threads at once. */
public final class JoinedMesh {
    private JoinedMesh() {}

    /** All triangles in one mesh, in their order, without normals and texture coordinates; the first mesh keeps what was made last. */
    public static TriangleMesh positionsOf(List<TriangleMesh> meshes) {
        return Union.of(meshes, List.of(), () -> joined(meshes));
    }

    /**
     * All triangles in one mesh, in their order and as they are placed, with their outside where it was; the first mesh keeps what was made last. Triangles that lose
     * their area by rounding are left out, and counted.
     */
    public static TriangleMesh positionsOf(List<TriangleMesh> meshes, List<? extends PlacedVertices> placings) {
        return Union.of(meshes, placings, () -> TriangleMesh.of(placed(meshes, placings), corners(meshes, placings)));
    }

    private static double[] placed(List<TriangleMesh> meshes, List<? extends PlacedVertices> placings) {
        double[] all = new double[Math.multiplyExact(3, vertices(meshes))];
        int at = 0;
        for (int k = 0; k < meshes.size(); k++) {
            VertexArrays of = meshes.get(k).data().vertices;
            PlacedVertices placing = placings.get(k);
            for (int v = 0; v < of.size(); v++) {
                double x = of.coordinate(v, 0);
                double y = of.coordinate(v, 1);
                double z = of.coordinate(v, 2);
                for (int axis = 0; axis < 3; axis++) {
                    all[at++] = placing.coordinate(axis, x, y, z);
                }
            }
        }
        return all;
    }

    private static int[] corners(List<TriangleMesh> meshes, List<? extends PlacedVertices> placings) {
        int[] all = corners(meshes);
        int at = 0;
        for (int k = 0; k < meshes.size(); k++) {
            int end = at + meshes.get(k).data().indices.length;
            for (; at < end; at += 3) {
                if (placings.get(k).isMirror()) {
                    int second = all[at + 1];
                    all[at + 1] = all[at + 2];
                    all[at + 2] = second;
                }
            }
        }
        return all;
    }

    private static int[] corners(List<TriangleMesh> meshes) {
        int triangles = Math.toIntExact(
                meshes.stream().mapToLong(TriangleMesh::triangles).sum());
        int[] all = new int[Math.multiplyExact(3, triangles)];
        int first = 0;
        int next = 0;
        for (TriangleMesh m : meshes) {
            for (int i : m.data().indices) {
                all[next++] = first + i;
            }
            first += m.vertices();
        }
        return all;
    }

    private static int vertices(List<TriangleMesh> meshes) {
        return Math.toIntExact(meshes.stream().mapToLong(TriangleMesh::vertices).sum());
    }

    private static TriangleMesh joined(List<TriangleMesh> meshes) {
        int numbers = Math.multiplyExact(3, vertices(meshes));
        boolean isOfFloats = meshes.stream().allMatch(TriangleMesh::isOfFloats);
        float[] floats = new float[isOfFloats ? numbers : 0];
        double[] doubles = new double[isOfFloats ? 0 : numbers];
        int at = 0;
        for (TriangleMesh m : meshes) {
            VertexArrays of = m.data().vertices;
            for (int i = 0; i < of.numbers(); i++, at++) {
                if (isOfFloats) {
                    floats[at] = (float) of.number(i);
                } else {
                    doubles[at] = of.number(i);
                }
            }
        }
        return isOfFloats ? TriangleMesh.of(floats, corners(meshes)) : TriangleMesh.of(doubles, corners(meshes));
    }
}
