package enlightenment.scene.json;

import enlightenment.mesh.MeshFiles;
import enlightenment.mesh.TriangleMesh;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** Cache of mesh files, which a scene and its shutter instants share while they are read. */
final class MeshCache {
    final Map<String, List<MeshFiles.Part>> parts = new HashMap<>();
    final Map<MeshFiles.Origin, TriangleMesh> meshes = new HashMap<>();

    /** Meshes of scenes made in code, by the names used in place of files. */
    final Map<String, LoadedMesh> named = new HashMap<>();
}
