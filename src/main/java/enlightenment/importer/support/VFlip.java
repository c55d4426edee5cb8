package enlightenment.importer.support;

import enlightenment.mesh.TriangleMesh;

/** Turns textures of meshes upside down: files disagree whether v grows upwards. */
public final class VFlip {
    private VFlip() {}

    /** The mesh with 1 − v for v, rounded to a float; the mesh itself if it has no texture coordinates. */
    public static TriangleMesh flipped(TriangleMesh mesh) {
        if (!mesh.hasUv()) {
            return mesh;
        }
        float[] uv = new float[2 * mesh.vertices()];
        for (int i = 0; i < mesh.vertices(); i++) {
            uv[2 * i] = (float) mesh.uv(i, 0);
            uv[2 * i + 1] = (float) (1 - mesh.uv(i, 1));
        }
        return mesh.withUv(uv);
    }
}
