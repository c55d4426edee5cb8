package enlightenment.mesh;

import enlightenment.math.Vec3;
import java.util.List;

/** Makes one mesh of several. */
public final class JoinedMesh {
    private JoinedMesh() {}

    /** All triangles in one mesh, in their order, without normals and texture coordinates; the first mesh keeps what was made last. */
    public static TriangleMesh positionsOf(List<TriangleMesh> meshes) {
        return meshes.get(0).union(meshes.subList(1, meshes.size()), () -> joined(meshes));
    }

    private static TriangleMesh joined(List<TriangleMesh> meshes) {
        int vertices = Math.toIntExact(
                meshes.stream().mapToLong(TriangleMesh::vertices).sum());
        int triangles = Math.toIntExact(
                meshes.stream().mapToLong(TriangleMesh::triangles).sum());
        int[] indices = new int[Math.multiplyExact(3, triangles)];
        boolean isOfFloats = meshes.stream().allMatch(TriangleMesh::isOfFloats);
        float[] floats = new float[isOfFloats ? Math.multiplyExact(3, vertices) : 0];
        double[] doubles = new double[isOfFloats ? 0 : Math.multiplyExact(3, vertices)];
        int first = 0;
        int next = 0;
        for (TriangleMesh m : meshes) {
            for (int i : m.indices()) {
                indices[next++] = first + i;
            }
            for (int v = 0; v < m.vertices(); v++) {
                for (int axis = 0; axis < 3; axis++) {
                    int at = 3 * (first + v) + axis;
                    if (isOfFloats) {
                        floats[at] = (float) m.coordinate(v, axis);
                    } else {
                        doubles[at] = m.coordinate(v, axis);
                    }
                }
            }
            first += m.vertices();
        }
        return isOfFloats ? TriangleMesh.of(floats, indices) : TriangleMesh.of(doubles, indices);
    }

    /** All triangles in one; normals and texture coordinates are kept where all have some. */
    static TriangleMesh of(List<MeshPart> parts) {
        if (parts.size() == 1) {
            return parts.get(0).mesh();
        }
        boolean hasNormals = parts.stream().allMatch(p -> p.mesh().hasNormals());
        boolean hasUv = parts.stream().allMatch(p -> p.mesh().hasUv());
        MeshBuilder all = new MeshBuilder();
        for (MeshPart part : parts) {
            TriangleMesh m = part.mesh();
            int first = all.vertices();
            for (int v = 0; v < m.vertices(); v++) {
                all.vertex(m.coordinate(v, 0), m.coordinate(v, 1), m.coordinate(v, 2));
                if (hasNormals) {
                    Vec3 n = m.normal(v);
                    all.normal(n.x(), n.y(), n.z());
                }
                if (hasUv) {
                    all.uv(m.uv(v, 0), m.uv(v, 1));
                }
            }
            all.triangles(m.indices(), first);
            all.triangles(m.withoutArea(), first);
        }
        return all.build();
    }
}
