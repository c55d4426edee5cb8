package enlightenment.scene.json;

import java.util.Map;

/**
 * The files of scenes that are in memory instead of on a disk, by the names that the scenes call them. Meshes that have been read from them are
 * kept for as long as this is: the frames of a film share them. For one thread at a time.
 */
public final class NamedFiles {
    final Map<String, byte[]> contents;
    final MeshCache files = new MeshCache();

    /** @param contents the files by their names */
    public NamedFiles(Map<String, byte[]> contents) {
        this.contents = Map.copyOf(contents);
    }
}
