package enlightenment.mesh;

import enlightenment.mesh.data.VertexArrays;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;

/** Writes meshes as PLY files: binary, little endian, coordinates as floats or doubles as the mesh has them. */
final class PlyWriter {
    /** More than a record takes. */
    private static final int RECORD = 64;

    private final TriangleMesh mesh;
    private final OutputStream out;
    private final ByteBuffer piece = ByteBuffer.allocate(1 << 16).order(ByteOrder.LITTLE_ENDIAN);

    private PlyWriter(TriangleMesh mesh, OutputStream out) {
        this.mesh = mesh;
        this.out = out;
    }

    static void write(TriangleMesh mesh, OutputStream out) throws IOException {
        new PlyWriter(mesh, out).write();
    }

    private void write() throws IOException {
        out.write(header().getBytes(StandardCharsets.US_ASCII));
        for (int v = 0; v < mesh.vertices(); v++) {
            vertex(v);
            flush(RECORD);
        }
        for (int t = 0; t < mesh.triangles(); t++) {
            piece.put((byte) 3);
            for (int k = 0; k < 3; k++) {
                piece.putInt(mesh.vertex(t, k));
            }
            flush(RECORD);
        }
        flush(piece.capacity());
        out.flush();
    }

    private String header() {
        String position = mesh.isOfFloats() ? "property float " : "property double ";
        StringBuilder text = new StringBuilder("ply\nformat binary_little_endian 1.0\n");
        text.append("element vertex ").append(mesh.vertices()).append('\n');
        for (String axis : new String[] {"x", "y", "z"}) {
            text.append(position).append(axis).append('\n');
        }
        text.append(mesh.hasNormals() ? "property float nx\nproperty float ny\nproperty float nz\n" : "");
        text.append(mesh.hasUv() ? "property float u\nproperty float v\n" : "");
        text.append("element face ").append(mesh.triangles()).append('\n');
        return text.append("property list uchar int vertex_indices\nend_header\n")
                .toString();
    }

    private void vertex(int v) {
        for (int axis = 0; axis < 3; axis++) {
            if (mesh.isOfFloats()) {
                piece.putFloat((float) mesh.coordinate(v, axis));
            } else {
                piece.putDouble(mesh.coordinate(v, axis));
            }
        }
        VertexArrays of = mesh.data().vertices;
        if (of.normals != null) {
            piece.putFloat(of.normals[3 * v]).putFloat(of.normals[3 * v + 1]).putFloat(of.normals[3 * v + 2]);
        }
        if (of.uv != null) {
            piece.putFloat(of.uv[2 * v]).putFloat(of.uv[2 * v + 1]);
        }
    }

    /** Writes the piece if less than some bytes of it are free. */
    private void flush(int free) throws IOException {
        if (piece.remaining() < free || free == piece.capacity()) {
            out.write(piece.array(), 0, piece.position());
            piece.clear();
        }
    }
}
