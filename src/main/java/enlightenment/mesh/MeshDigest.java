package enlightenment.mesh;

import enlightenment.file.ContentHash;
import enlightenment.mesh.data.VertexArrays;
import java.nio.ByteBuffer;
import java.security.MessageDigest;

/** Hashes the numbers of a mesh, piece by piece. */
final class MeshDigest {
    private static final int PIECE = 1 << 13;

    private final MessageDigest sha = ContentHash.sha256();
    private final ByteBuffer piece = ByteBuffer.allocate(PIECE);

    private MeshDigest() {}

    /** 64 hexadecimal digits; zeros of either sign count as one number. */
    static String of(VertexArrays vertices, int[] indices) {
        return new MeshDigest().digest(vertices, indices);
    }

    private String digest(VertexArrays vertices, int[] indices) {
        int numbers = vertices.numbers();
        piece.putInt(numbers).putInt(indices.length);
        piece.putInt((vertices.normals == null ? 0 : 1) + (vertices.uv == null ? 0 : 2));
        for (int i = 0; i < numbers; i++) {
            flushIfFull();
            piece.putDouble(vertices.number(i) + 0.0);
        }
        for (int v : indices) {
            flushIfFull();
            piece.putInt(v);
        }
        update(vertices.normals);
        update(vertices.uv);
        sha.update(piece.flip());
        return ContentHash.fromBytes(sha.digest()).toString();
    }

    private void update(float[] values) {
        for (int i = 0; values != null && i < values.length; i++) {
            flushIfFull();
            piece.putFloat(values[i] + 0f);
        }
    }

    private void flushIfFull() {
        if (piece.remaining() < Double.BYTES) {
            sha.update(piece.flip());
            piece.clear();
        }
    }
}
