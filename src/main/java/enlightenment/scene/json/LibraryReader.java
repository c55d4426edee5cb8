package enlightenment.scene.json;

import enlightenment.scene.json.tree.JsonPointer;
import enlightenment.scene.json.tree.JsonValue;

/** Reads the named meshes, textures, materials and groups of a scene. */
final class LibraryReader {
    private LibraryReader() {}

    /** Reads the scene's named parts into the library; each of them is optional. */
    static void read(JsonValue.Obj scene, Values values) {
        JsonValue meshes = scene.get("meshes");
        if (meshes != null) {
            Meshes.readNamed(meshes, JsonPointer.ROOT.child("meshes"), values);
        }
        JsonValue textures = scene.get("textures");
        if (textures != null) {
            Textures.readNamed(textures, JsonPointer.ROOT.child("textures"), values);
        }
        JsonValue materials = scene.get("materials");
        if (materials != null) {
            Materials.readNamed(materials, JsonPointer.ROOT.child("materials"), values);
        }
        JsonValue groups = scene.get("groups");
        if (groups != null) {
            Groups.note(groups, JsonPointer.ROOT.child("groups"), values);
        }
    }
}
