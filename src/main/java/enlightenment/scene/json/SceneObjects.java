package enlightenment.scene.json;

import enlightenment.geometry.Shape;
import enlightenment.material.Material;
import enlightenment.scene.SceneObject;
import enlightenment.text.Plain;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** Reads the objects: shapes and what they are made of. */
final class SceneObjects {
    private static final JsonPointer PLACE = JsonPointer.ROOT.child("objects");

    private final Values values;
    private final List<SceneObject> objects = new ArrayList<>();
    private final Map<String, JsonValue> names = new HashMap<>();

    SceneObjects(Values values) {
        this.values = values;
    }

    /** The next object, unless it has a problem. */
    void add(JsonValue v, int index) {
        Fields f = Fields.of(v, PLACE.child(index), Shapes.FAMILY, values);
        SceneObject object = f == null ? null : object(f);
        if (object != null) {
            objects.add(object);
        }
    }

    /** The objects that have no problems. */
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
        // Null where a material has a problem of its own that is not this object's.
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
