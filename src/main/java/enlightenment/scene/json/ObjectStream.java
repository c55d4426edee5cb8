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
 * The objects of a scene, each bound as soon as its text is read and then forgotten as JSON, so that a million of them never
 * stand in memory as JSON.
 *
 * <p>What an object refers to may stand behind it in the file, and tracks may lead to its numbers. The first reading goes by what
 * stands before the objects; where that was not everything, the text is read again. The problems are those that binding
 * everything at the end finds, in its order.
 */
final class ObjectStream {
    /** The parts that objects refer to. */
    private static final Set<String> LIBRARY = Set.of("meshes", "textures", "materials", "groups");

    private final JsonTree.Source source;
    private final Values values;
    private final Problems ofLibrary;
    private Pass pass;

    /** @param values receive the problems and, from {@link #prepare} on, the library */
    ObjectStream(JsonTree.Source source, Values values) {
        this.source = source;
        this.values = values;
        this.ofLibrary = values.problems().ofPart();
    }

    /** One reading of the text. */
    private final class Pass implements JsonTree.ObjectSink {
        /** The array of objects of an earlier reading, with those that are to be taken instead; null in the first reading. */
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
                // Its problems are found once more when it is known to be all.
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

    /** Reads the text; null after a problem. In what is returned, null stands for each object. */
    JsonValue readAll() {
        pass = new Pass(null);
        return JsonTree.parse(source, values.problems(), pass);
    }

    /** Puts the objects that tracks lead into in their places again. */
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
                // The array that counts is the last one, and it is the one that the text's value has.
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

    /** What was wrong with the text itself is known from the first reading, unless the file has changed since. */
    private JsonValue readAgain(JsonTree.ObjectSink objects) {
        Problems again = values.problems().ofPart();
        JsonValue root = JsonTree.parse(source, again, objects);
        if (root == null) {
            values.problems().add(again);
        }
        return root;
    }

    /** The parts of the pointers that tracks lead to, as far as they are pointers. */
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
     * @param animated whether the numbers of a frame were put into the scene
     */
    void prepare(JsonValue.Obj scene, boolean animated) {
        boolean stands = pass.objects != null && standsBehindLibrary(scene) && !(animated && changesObjects(scene));
        Library library = values.library();
        LibraryReader.read(scene, new Values(ofLibrary, library));
        if (stands) {
            // The materials that the objects have already, instead of equal ones.
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

    /** Whether a track leads to an object or to what objects are made of. */
    private static boolean changesObjects(JsonValue.Obj scene) {
        return targets(scene).stream()
                .anyMatch(t -> !t.isEmpty() && (t.get(0).equals("objects") || LIBRARY.contains(t.get(0))));
    }

    /** Reports the problems of textures and materials. */
    void tellLibrary() {
        values.problems().add(ofLibrary);
    }

    /** The objects that have no problems; tells those of the others. */
    List<SceneObject> objects(JsonValue v, JsonPointer place) {
        if (values.array(v, place, -1, "an array of objects") == null || pass.objects == null) {
            return List.of();
        }
        pass.objects.readOtherGroups();
        values.problems().add(pass.ofObjects);
        return pass.objects.all();
    }
}
