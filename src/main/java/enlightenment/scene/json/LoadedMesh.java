package enlightenment.scene.json;

import enlightenment.mesh.MeshFiles;
import enlightenment.mesh.TriangleMesh;
import java.util.Optional;

/** A mesh with what is said of where it comes from. */
record LoadedMesh(TriangleMesh mesh, Optional<MeshFiles.Origin> origin) {}
