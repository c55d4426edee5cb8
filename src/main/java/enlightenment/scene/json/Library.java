package enlightenment.scene.json;

import enlightenment.material.Material;
import enlightenment.material.Texture;
import enlightenment.scene.SceneObject;
import enlightenment.scene.json.tree.JsonValue;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;

/** The named parts of a scene, as far as they have been read, and its files. */
final class Library {
    /** Textures by name; null for one whose problem has been reported. */
    final Map<String, Texture> textures = new LinkedHashMap<>();

    /** Meshes by name; null for one whose problem has been reported. */
    final Map<String, LoadedMesh> meshes = new LinkedHashMap<>();

    /** Objects of the groups that have been read, by name; null for one whose problem has been reported. */
    final Map<String, List<SceneObject>> groups = new LinkedHashMap<>();

    /** Nesting depths of the groups that have been read, themselves included. */
    final Map<String, Integer> groupDepths = new HashMap<>();

    /** Numbers of objects that groups place, those of nested groups included. */
    final Map<String, Long> groupCounts = new HashMap<>();

    /** All groups as JSON, by name. */
    final Map<String, JsonValue> unreadGroups = new LinkedHashMap<>();

    /** Materials by name; null for one whose problem has been reported. */
    final Map<String, Material> materials = new LinkedHashMap<>();

    /** Image files with unbounded radiance, which cannot be colours of surfaces. */
    final Set<Path> lightFiles = new HashSet<>();

    /** The folder that the paths of image files are relative to. */
    final Path folder;

    /** Contents of files in memory by their names; null if files are on the disk. */
    final Map<String, byte[]> contents;

    /** Cache of mesh files. */
    final MeshCache files;

    Library(Path folder, Map<String, byte[]> contents, MeshCache files) {
        this.folder = folder.toAbsolutePath();
        this.contents = contents;
        this.files = files;
    }

    /** An empty library with the same files. */
    Library unread() {
        return new Library(folder, contents, files);
    }
}
