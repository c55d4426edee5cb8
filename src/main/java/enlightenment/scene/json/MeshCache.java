package enlightenment.scene.json;

import enlightenment.mesh.MeshFiles;
import enlightenment.mesh.TriangleMesh;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** Files of meshes that have been read, for as long as a scene and its instants are read. */
final class MeshCache {
    final Map<String, List<MeshFiles.Part>> parts = new HashMap<>();
    final Map<MeshFiles.Origin, TriangleMesh> meshes = new HashMap<>();

    /** Meshes of scenes made in code, by the names that stand in place of files. */
    final Map<String, LoadedMesh> named = new HashMap<>();
}
