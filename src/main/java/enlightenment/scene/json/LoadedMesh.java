package enlightenment.scene.json;

import enlightenment.mesh.MeshFiles;
import enlightenment.mesh.TriangleMesh;
import java.util.Optional;

/** A mesh with the file and processing it was read with; no origin for meshes made in code. */
record LoadedMesh(TriangleMesh mesh, Optional<MeshFiles.Origin> origin) {}
