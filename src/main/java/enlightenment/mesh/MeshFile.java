package enlightenment.mesh;

import java.util.List;

/**
 * What a mesh file holds.
 *
 * @param parts at least one
 * @param materialLibraries the names of MTL files as an OBJ file has them, which are relative to its folder; else none
 */
public record MeshFile(List<MeshPart> parts, List<String> materialLibraries) {
    /** Copies the lists. */
    public MeshFile {
        parts = List.copyOf(parts);
        materialLibraries = List.copyOf(materialLibraries);
    }
}
