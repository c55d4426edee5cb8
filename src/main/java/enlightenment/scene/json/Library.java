package enlightenment.scene.json;

import enlightenment.material.Material;
import enlightenment.material.Texture;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Set;

/** What a scene calls by names: its textures and materials as far as they have been read, and image files. */
final class Library {
    /** Null for a texture that is there but wrong: its own problem is enough. */
    final Map<String, Texture> textures = new LinkedHashMap<>();

    /** Null for a material that is there but wrong: its own problem is enough. */
    final Map<String, Material> materials = new LinkedHashMap<>();

    /** Those image files whose numbers are light without limits: no surface has such a colour. */
    final Set<Path> lightFiles = new HashSet<>();

    /** What the paths of image files are relative to. */
    final Path folder;

    /** The names of image files that are not on the disk; null if they are. */
    final Set<String> fileNames;

    Library(Path folder, Set<String> fileNames) {
        this.folder = folder.toAbsolutePath();
        this.fileNames = fileNames;
    }

    /** One of the same image files that nothing has been read into. */
    Library unread() {
        return new Library(folder, fileNames);
    }

    /** Reads a scene's textures and materials, as far as they are there. */
    static void read(JsonValue.Obj scene, Values values) {
        JsonValue textures = scene.get("textures");
        if (textures != null) {
            Textures.readNamed(textures, JsonPointer.ROOT.child("textures"), values);
        }
        JsonValue materials = scene.get("materials");
        if (materials != null) {
            Materials.readNamed(materials, JsonPointer.ROOT.child("materials"), values);
        }
    }
}
