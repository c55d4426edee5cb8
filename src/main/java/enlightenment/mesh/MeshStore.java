package enlightenment.mesh;

import enlightenment.mesh.data.MeshData;

/** Hands what a mesh is made of to packages that are not exported; programs cannot name its type. */
abstract class MeshStore {
    private final MeshData data;

    MeshStore(MeshData data) {
        this.data = data;
    }

    /**
     * What the mesh is made of.
     *
     * @hidden
     */
    public final MeshData data() {
        return data;
    }
}
