package enlightenment.mesh;

/**
 * A part of a mesh file: the triangles of one material, or one shape of a {@code .serialized} file.
 *
 * @param material the name of the material, or ""
 * @param mesh its triangles
 */
public record MeshPart(String material, TriangleMesh mesh) {}
