package enlightenment.scene.json;

import enlightenment.scene.json.tree.JsonPointer;
import enlightenment.scene.json.tree.JsonValue;

/** Reads what a scene has names for. */
final class LibraryReader {
    private LibraryReader() {}

    /** Reads a scene's meshes, textures and materials, as far as they are there. */
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
