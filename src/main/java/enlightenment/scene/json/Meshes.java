package enlightenment.scene.json;

import enlightenment.file.FileFailure;
import enlightenment.geometry.Mesh;
import enlightenment.geometry.Transform;
import enlightenment.mesh.MeshFiles;
import enlightenment.mesh.TriangleMesh;
import enlightenment.scene.json.tree.JsonPointer;
import enlightenment.scene.json.tree.JsonValue;
import enlightenment.text.PathText;
import enlightenment.text.Plain;
import enlightenment.text.Suggestion;
import java.io.IOException;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** Reads meshes from files: named ones, and those of objects. */
final class Meshes {
    static final Keys NAMED = Keys.of("mesh", "a mesh", "file", "part normals crease");

    private Meshes() {}

    /** Reads the part {@code meshes} into the library. */
    static void readNamed(JsonValue v, JsonPointer place, Values values) {
        JsonValue.Obj o = values.object(v, place, "meshes by their names");
        for (int i = 0; o != null && i < o.size(); i++) {
            Fields f = Fields.of(o.value(i), place.child(o.key(i)), NAMED, values);
            values.library().meshes.put(o.key(i), f == null ? null : load(f));
        }
    }

    /** The shape of an object. */
    static Mesh shape(Fields f) {
        Transform transform = Transforms.read(f);
        if (f.has("mesh") == f.has("file")) {
            f.problem(
                    f.has("mesh") ? "file" : "mesh",
                    f.has("mesh")
                            ? "an object has a mesh by its name or by its file, not both"
                            : "missing; a mesh needs the name of one of the scene's meshes, or a \"file\"");
            return null;
        }
        LoadedMesh loaded = f.has("mesh") ? named(f) : load(f);
        return loaded == null || transform == null
                ? null
                : f.make(() -> new Mesh(loaded.mesh(), loaded.origin(), transform));
    }

    private static LoadedMesh named(Fields f) {
        for (String key : NAMED.optional()) {
            if (f.has(key)) {
                f.problem(key, "stands where the mesh has its name");
            }
        }
        Map<String, LoadedMesh> named = f.values().library().meshes;
        String name = f.text("mesh", "the name of a mesh");
        if (name != null && !named.containsKey(name)) {
            String instead = named.isEmpty()
                    ? "; the scene names no meshes (/meshes)"
                    : Suggestion.of(name, named.keySet(), "there are");
            f.problem("mesh", "unknown mesh " + Plain.quoted(name) + instead);
        }
        return name == null ? null : named.get(name);
    }

    private static LoadedMesh load(Fields f) {
        String written = f.text("file", "the path of a file: PLY, OBJ, STL or .serialized");
        if (written != null && f.values().library().files.named.containsKey(written)) {
            return f.values().library().files.named.get(written);
        }
        String part = f.text("part", "the name of a material, or the number of a shape");
        MeshFiles.Origin.Normals normals = f.word("normals", MeshFiles.Origin.Normals.FILE);
        double crease = f.number("crease", 180);
        if (f.has("crease") && normals != MeshFiles.Origin.Normals.SMOOTH) {
            f.problem("crease", "means something with \"normals\": \"smooth\" only");
            return null;
        }
        Path file = written == null ? null : path(f, written);
        MeshFiles.Origin origin = file == null
                ? null
                : f.make(() -> new MeshFiles.Origin(file, part == null ? "" : part, normals, crease));
        if (origin == null) {
            return null;
        }
        try {
            return new LoadedMesh(mesh(origin, written, f.values().library()), Optional.of(origin));
        } catch (IOException e) {
            f.problem("file", FileFailure.described(e));
            return null;
        }
    }

    /** The path of a file name, relative to the scene or among the files in memory; null after a problem. */
    static Path path(Fields f, String written) {
        Library library = f.values().library();
        if (library.contents != null) {
            if (!library.contents.containsKey(written)) {
                f.problem("file", "there is no file " + Plain.quoted(written));
                return null;
            }
            return Path.of(written);
        }
        try {
            Path file = library.folder.resolve(written).normalize();
            if (java.nio.file.Files.exists(file)) {
                return file;
            }
            f.problem("file", "there is no file " + Plain.quoted(written) + " (" + file + ")");
            return null;
        } catch (InvalidPathException e) {
            f.problem("file", PathText.reason(e));
            return null;
        }
    }

    private static TriangleMesh mesh(MeshFiles.Origin origin, String written, Library library) throws IOException {
        TriangleMesh known = library.files.meshes.get(origin);
        if (known != null) {
            return known;
        }
        String key = origin.file().toString();
        List<MeshFiles.Part> parts = library.files.parts.get(key);
        if (parts == null) {
            parts = library.contents == null
                    ? MeshFiles.read(origin.file(), MeshFiles.MAX_TRIANGLES)
                    : MeshFiles.read(library.contents.get(written), written, MeshFiles.MAX_TRIANGLES);
            library.files.parts.put(key, parts);
        }
        TriangleMesh mesh = origin.of(parts);
        library.files.meshes.put(origin, mesh);
        return mesh;
    }

    static void write(Mesh mesh, JsonObjectBuilder p) {
        p.meshFile("file", mesh);
        Transforms.write(mesh.transform(), p);
    }
}
