package enlightenment.scene.json;

import enlightenment.scene.SceneObject;
import enlightenment.scene.json.tree.JsonPointer;
import enlightenment.scene.json.tree.JsonTree;
import enlightenment.scene.json.tree.JsonValue;
import enlightenment.scene.json.tree.Problems;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;

/**
 * Streaming binder of the objects of a scene. Each is bound as soon as its text is parsed and then discarded as JSON, so that a million objects
 * are never in memory as JSON.
 *
 * <p>The parts that an object refers to may follow it in the file, and tracks may target its numbers. The first pass uses the parts before the
 * objects; if others follow, the text is parsed again. Problems and their order are those of binding the whole document at the end.
 */
final class ObjectStream {
    /** Keys of the parts that objects refer to. */
    private static final Set<String> LIBRARY = Set.of("meshes", "textures", "materials", "groups");

    private final JsonTree.Source source;
    private final Values values;
    private final Problems ofLibrary;
    private Pass pass;

    /** @param values receives the problems and, from {@link #prepare} on, the library */
    ObjectStream(JsonTree.Source source, Values values) {
        this.source = source;
        this.values = values;
        this.ofLibrary = values.problems().ofPart();
    }

    /** One pass over the text. */
    private final class Pass implements JsonTree.ObjectSink {
        /** Objects of an earlier pass that replace those of the text, null items aside; null in the first pass. */
        private final JsonValue.Arr instead;

        private Library library = values.library();
        private Problems ofObjects;
        private SceneObjects objects;

        Pass(JsonValue.Arr instead) {
            this.instead = instead;
        }

        @Override
        public void begin(JsonValue.Obj before) {
            if (instead == null) {
                library = library.unread();
                // The problems are discarded: the library is read again when it is complete.
                LibraryReader.read(before, new Values(values.problems().ofPart(), library));
            }
            ofObjects = values.problems().ofPart();
            objects = new SceneObjects(new Values(ofObjects, library));
        }

        @Override
        public JsonValue take(int index, JsonValue v) {
            JsonValue other = instead == null || index >= instead.size() ? null : instead.get(index);
            objects.add(other == null ? v : other, index);
            return null;
        }
    }

    /** Parses the text; null after a problem. In the result, null stands for each object. */
    JsonValue readAll() {
        pass = new Pass(null);
        return JsonTree.parse(source, values.problems(), pass);
    }

    /** Restores the JSON of objects that tracks target. */
    void keepTargets(JsonValue.Obj scene) {
        Set<Integer> indices = new HashSet<>();
        for (List<String> target : targets(scene)) {
            if (target.size() > 1
                    && target.get(0).equals("objects")
                    && target.get(1).matches("[0-9]{1,9}")) {
                indices.add(Integer.parseInt(target.get(1)));
            }
        }
        if (indices.isEmpty() || !(scene.get("objects") instanceof JsonValue.Arr)) {
            return;
        }
        JsonValue again = readAgain(new JsonTree.ObjectSink() {
            @Override
            public void begin(JsonValue.Obj before) {
                // Nothing to do: of several arrays the last one counts, which is that of the parsed root.
            }

            @Override
            public JsonValue take(int index, JsonValue v) {
                return indices.contains(index) ? v : null;
            }
        });
        if (again instanceof JsonValue.Obj o && o.get("objects") instanceof JsonValue.Arr kept) {
            scene.replace("objects", kept);
        }
    }

    /** Parses the text again. Its problems are known from the first pass, unless it fails now because the file has changed. */
    private JsonValue readAgain(JsonTree.ObjectSink objects) {
        Problems again = values.problems().ofPart();
        JsonValue root = JsonTree.parse(source, again, objects);
        if (root == null) {
            values.problems().add(again);
        }
        return root;
    }

    /** The targets of the tracks as parts of JSON pointers; invalid pointers are left out. */
    private static List<List<String>> targets(JsonValue.Obj scene) {
        List<List<String>> targets = new ArrayList<>();
        boolean some = scene.get("animation") instanceof JsonValue.Obj animation
                && animation.get("tracks") instanceof JsonValue.Arr;
        JsonValue.Arr tracks = some ? (JsonValue.Arr) ((JsonValue.Obj) scene.get("animation")).get("tracks") : null;
        for (int i = 0; some && i < tracks.size(); i++) {
            boolean text = tracks.get(i) instanceof JsonValue.Obj track && track.get("target") instanceof JsonValue.Str;
            List<String> target = text
                    ? JsonPointer.parse(((JsonValue.Str) ((JsonValue.Obj) tracks.get(i)).get("target")).text)
                    : null;
            if (target != null) {
                targets.add(target);
            }
        }
        return targets;
    }

    /**
     * Completes the library and the objects.
     *
     * @param animated whether the tracks have been applied to the scene
     */
    void prepare(JsonValue.Obj scene, boolean animated) {
        boolean stands = pass.objects != null && standsBehindLibrary(scene) && !(animated && changesObjects(scene));
        Library library = values.library();
        LibraryReader.read(scene, new Values(ofLibrary, library));
        if (stands) {
            // Keeps the instances that the objects refer to, in place of equal ones.
            library.meshes.putAll(pass.library.meshes);
            library.textures.putAll(pass.library.textures);
            library.materials.putAll(pass.library.materials);
            library.groups.putAll(pass.library.groups);
            library.groupDepths.putAll(pass.library.groupDepths);
        } else if (scene.get("objects") instanceof JsonValue.Arr objects) {
            pass = new Pass(objects);
            readAgain(pass);
        }
    }

    private static boolean standsBehindLibrary(JsonValue.Obj scene) {
        int objects = -1;
        int library = -1;
        for (int i = 0; i < scene.size(); i++) {
            objects = scene.key(i).equals("objects") ? i : objects;
            library = LIBRARY.contains(scene.key(i)) ? i : library;
        }
        return objects > library;
    }

    /** Whether a track targets an object or a part that objects refer to. */
    private static boolean changesObjects(JsonValue.Obj scene) {
        return targets(scene).stream()
                .anyMatch(t -> !t.isEmpty() && (t.get(0).equals("objects") || LIBRARY.contains(t.get(0))));
    }

    /** Reports the problems of the library. */
    void tellLibrary() {
        values.problems().add(ofLibrary);
    }

    /** The objects without problems; those of the others are reported. */
    List<SceneObject> objects(JsonValue v, JsonPointer place) {
        if (values.array(v, place, -1, "an array of objects") == null || pass.objects == null) {
            return List.of();
        }
        pass.objects.readOtherGroups();
        values.problems().add(pass.ofObjects);
        return pass.objects.all();
    }
}
