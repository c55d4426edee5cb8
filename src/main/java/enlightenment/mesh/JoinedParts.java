package enlightenment.mesh;

import enlightenment.math.Vec3;
import java.util.List;

/** Makes one mesh of the parts of a file. */
final class JoinedParts {
    private JoinedParts() {}

    /** All triangles in one; normals and texture coordinates are kept where all have some. */
    static TriangleMesh of(List<MeshFiles.Part> parts) {
        if (parts.size() == 1) {
            return parts.get(0).mesh();
        }
        boolean hasNormals = parts.stream().allMatch(p -> p.mesh().hasNormals());
        boolean hasUv = parts.stream().allMatch(p -> p.mesh().hasUv());
        MeshBuilder all = new MeshBuilder();
        for (MeshFiles.Part part : parts) {
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
            all.triangles(m.data().indices, first);
            all.triangles(m.data().withoutArea, first);
        }
        return all.build();
    }
}
