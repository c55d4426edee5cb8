package enlightenment.mesh;

import enlightenment.mesh.data.VertexArrays;
import enlightenment.mesh.input.MeshSource;
import java.io.IOException;
import java.util.Optional;

/** The triangles of one material of an OBJ file. Its vertices are the combinations of position, texture coordinates and normal in use. */
final class ObjPart {
    final String material;
    private final VertexTable vertices = new VertexTable();
    private final Ints indices = new Ints(12);
    private boolean lacksUv;
    private boolean hasNormals;

    ObjPart(String material) {
        this.material = material;
    }

    /** The vertex of a corner; texture coordinates and normal are -1 if the corner has none. */
    int vertex(int position, int uv, int normal) {
        lacksUv |= uv < 0;
        hasNormals |= normal >= 0;
        return vertices.number(position, uv, normal);
    }

    void triangle(int a, int b, int c) {
        indices.add(a);
        indices.add(b);
        indices.add(c);
    }

    /**
     * The mesh; empty if no triangle has an area. Without texture coordinates at each corner it has none; corners without a normal among others
     * get the zero normal, which stands for the geometric one.
     */
    Optional<TriangleMesh> mesh(MeshSource source, Floats positions, Floats uv, Floats normals) throws IOException {
        vertices.freeze();
        float[] p = gathered(positions, 3, 0);
        float[] t = lacksUv ? null : gathered(uv, 2, 1);
        float[] n = hasNormals ? gathered(normals, 3, 2) : null;
        MeshMaking making = () -> new TriangleMesh(new VertexArrays(p, null, n, t), indices.toArray());
        return making.withArea(source);
    }

    private float[] gathered(Floats values, int each, int which) {
        float[] some = new float[each * vertices.size()];
        for (int v = 0; v < vertices.size(); v++) {
            int from = vertices.part(v, which);
            for (int i = 0; i < each; i++) {
                some[each * v + i] = from < 0 ? 0 : values.get(each * from + i);
            }
        }
        return some;
    }
}
