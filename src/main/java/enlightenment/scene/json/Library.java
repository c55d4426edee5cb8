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

/** What a scene calls by names: its meshes, textures and materials as far as they have been read, and image files. */
final class Library {
    /** Null for a texture that is there but wrong: its own problem is enough. */
    final Map<String, Texture> textures = new LinkedHashMap<>();

    /** Null for a mesh that is there but wrong: its own problem is enough. */
    final Map<String, LoadedMesh> meshes = new LinkedHashMap<>();

    /** The groups that have been read, by their names; null for one with a problem of its own. */
    final Map<String, List<SceneObject>> groups = new LinkedHashMap<>();

    /** How many groups lie in each other in a group that has been read, itself included. */
    final Map<String, Integer> groupDepths = new HashMap<>();

    /** How many objects a group places, those in its groups included. */
    final Map<String, Long> groupCounts = new HashMap<>();

    /** All groups, as they are written. */
    final Map<String, JsonValue> unreadGroups = new LinkedHashMap<>();

    /** Null for a material that is there but wrong: its own problem is enough. */
    final Map<String, Material> materials = new LinkedHashMap<>();

    /** Those image files whose numbers are light without limits: no surface has such a colour. */
    final Set<Path> lightFiles = new HashSet<>();

    /** The folder that the paths of image files are relative to. */
    final Path folder;

    /** What files hold that are not on the disk, by their names; null if they are. */
    final Map<String, byte[]> contents;

    /** Files of meshes that have been read. */
    final MeshCache files;

    Library(Path folder, Map<String, byte[]> contents, MeshCache files) {
        this.folder = folder.toAbsolutePath();
        this.contents = contents;
        this.files = files;
    }

    /** One of the same image files that nothing has been read into. */
    Library unread() {
        return new Library(folder, contents, files);
    }
}
