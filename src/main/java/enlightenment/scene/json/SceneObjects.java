package enlightenment.scene.json;

import enlightenment.geometry.Shape;
import enlightenment.geometry.Transform;
import enlightenment.material.Material;
import enlightenment.scene.SceneObject;
import enlightenment.scene.json.tree.JsonPointer;
import enlightenment.scene.json.tree.JsonValue;
import enlightenment.text.Plain;
import enlightenment.text.Suggestion;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** Reads the objects: shapes with their materials, and placed groups. */
final class SceneObjects {
    private static final JsonPointer PLACE = JsonPointer.ROOT.child("objects");

    private final Values values;
    private final List<SceneObject> objects = new ArrayList<>();

    /** Number of objects placed by groups so far. */
    private long ofGroups;

    private final Map<String, JsonValue> names = new HashMap<>();

    /** Greatest nesting depth of the groups placed so far. */
    private int depth;

    SceneObjects(Values values) {
        this.values = values;
    }

    /** Adds the next object, or the objects of a placed group; reports it instead if it has a problem. */
    void add(JsonValue v, int index) {
        add(v, PLACE.child(index), List.of());
    }

    /** @param within names of the enclosing groups, the outermost first */
    private void add(JsonValue v, JsonPointer place, List<String> within) {
        if (v instanceof JsonValue.Obj o
                && o.get("type") instanceof JsonValue.Str type
                && type.text.equals(Groups.TYPE)) {
            addGroup(v, place, within);
            return;
        }
        Fields f = Fields.of(v, place, Shapes.FAMILY, values);
        SceneObject object = f == null ? null : object(f);
        if (object != null) {
            objects.add(object);
        }
    }

    private void addGroup(JsonValue v, JsonPointer place, List<String> within) {
        Fields f = Fields.of(v, place, Groups.OBJECT, values);
        if (f == null) {
            return;
        }
        name(f);
        Transform transform = Transforms.read(f);
        if (v instanceof JsonValue.Obj o && o.get("group") instanceof JsonValue.Str group) {
            ofGroups += Groups.count(values.library(), group.text, 0);
            if (ofGroups > Groups.MOST_PLACED) {
                f.problem("group", Groups.TOO_MUCH);
                return;
            }
        }
        List<SceneObject> members = members(f, within);
        for (SceneObject member : members == null || transform == null ? List.<SceneObject>of() : members) {
            SceneObject placed = f.make(() -> member.placed(transform, ""));
            if (placed == null) {
                return;
            }
            objects.add(placed);
        }
    }

    /** The objects of a group; null after a problem of the reference or of the group. */
    private List<SceneObject> members(Fields f, List<String> within) {
        String name = f.text("group", "the name of a group");
        Library library = values.library();
        if (name == null) {
            return null;
        }
        if (!library.unreadGroups.containsKey(name)) {
            f.problem(
                    "group",
                    "unknown group " + Plain.quoted(name)
                            + (library.unreadGroups.isEmpty()
                                    ? "; the scene names no groups (/groups)"
                                    : Suggestion.of(name, library.unreadGroups.keySet(), "there are")));
            return null;
        }
        if (within.contains(name)) {
            f.problem("group", Groups.circle(name, within));
            return null;
        }
        if (!library.groups.containsKey(name) && within.size() < Groups.DEEPEST) {
            read(name, within);
        }
        int inside = library.groupDepths.getOrDefault(name, 1);
        if (within.size() + inside > Groups.DEEPEST) {
            f.problem("group", "groups lie in each other more than " + Groups.DEEPEST + " deep");
            return null;
        }
        depth = Math.max(depth, inside);
        return library.groups.get(name);
    }

    /** Reads groups that no object places, for their problems. */
    void readOtherGroups() {
        for (String name : List.copyOf(values.library().unreadGroups.keySet())) {
            if (!values.library().groups.containsKey(name)) {
                read(name, List.of());
            }
        }
    }

    private void read(String name, List<String> within) {
        Library library = values.library();
        JsonValue written = library.unreadGroups.get(name);
        int before = values.problems().count();
        SceneObjects inner = new SceneObjects(values);
        List<String> chain = new ArrayList<>(within);
        chain.add(name);
        JsonPointer place = JsonPointer.ROOT.child("groups").child(name);
        if (Groups.count(library, name, 0) > Groups.MOST_PLACED) {
            values.problems().add(written, place, Groups.TOO_MUCH);
            library.groups.put(name, null);
            return;
        }
        JsonValue.Arr a = values.array(written, place, -1, "an array of objects");
        for (int i = 0; a != null && i < a.size(); i++) {
            inner.add(a.get(i), place.child(i), chain);
        }
        library.groups.put(name, values.problems().count() > before ? null : inner.objects);
        library.groupDepths.put(name, 1 + inner.depth);
    }

    /** The objects without problems. */
    List<SceneObject> all() {
        return objects;
    }

    private SceneObject object(Fields f) {
        String name = name(f);
        Shape shape = Shapes.FAMILY.read(f);
        List<Material> faces = faces(f);
        Material material = f.has("material") ? Materials.use(f.get("material"), f.at("material"), values) : null;
        if (!f.has("material") && f.type(null).equals("cube")) {
            if (!f.has("faces")) {
                f.problem("material", "missing; a cube needs it, or \"faces\"");
            } else if (!faces.isEmpty()) {
                return object(f, name, shape, faces.get(0), faces);
            }
        }
        return object(f, name, shape, material, faces);
    }

    private static SceneObject object(Fields f, String name, Shape shape, Material material, List<Material> faces) {
        // A material is null after a problem that was reported where the material is defined.
        boolean complete = shape != null && material != null && !faces.contains(null);
        return complete ? f.make(() -> new SceneObject(name, shape, material, List.copyOf(faces))) : null;
    }

    private String name(Fields f) {
        String name = f.text("name", "a text");
        if (name == null || name.isEmpty()) {
            return "";
        }
        JsonValue first = names.putIfAbsent(name, f.get("name"));
        if (first != null) {
            f.problem(
                    "name",
                    "the name " + Plain.quoted(name) + " is used twice; first in line " + first.line + ", column "
                            + first.column);
        }
        return name;
    }

    private List<Material> faces(Fields f) {
        List<Material> faces = new ArrayList<>();
        JsonValue v = f.type(null).equals("cube") ? f.get("faces") : null;
        JsonValue.Arr a = v == null
                ? null
                : values.array(v, f.at("faces"), 6, "an array of six materials (-x, +x, -y, +y, -z, +z)");
        for (int i = 0; a != null && i < 6; i++) {
            faces.add(Materials.use(a.get(i), f.at("faces").child(i), values));
        }
        return faces;
    }
}
