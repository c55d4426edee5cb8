package enlightenment.scene.json;

import enlightenment.mesh.MeshOrigin;
import enlightenment.mesh.TriangleMesh;

/** A mesh with what is said of where it comes from. */
record LoadedMesh(TriangleMesh mesh, MeshOrigin origin) {}
