package enlightenment.scene.json;

import enlightenment.geometry.Box;
import enlightenment.geometry.Cone;
import enlightenment.geometry.Cube;
import enlightenment.geometry.Cylinder;
import enlightenment.geometry.Disk;
import enlightenment.geometry.Rectangle;
import enlightenment.geometry.Shape;
import enlightenment.geometry.Sphere;
import enlightenment.geometry.Torus;
import enlightenment.geometry.Triangle;
import enlightenment.material.Material;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.scene.SceneObject;
import enlightenment.text.Plain;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;

/** Reads the objects: shapes and what they are made of. */
final class SceneObjects {
    static final String CORNERS = "four corners [x, y, z]: lower left, upper left, upper right, lower right";

    private static final Fields.Family FAMILY =
            new Fields.Family("an object of the scene", Vocabulary.OBJECTS, Vocabulary.PLANNED_OBJECTS, List.of());

    private static final Map<String, Function<Fields, Shape>> SHAPES = Map.of(
            "sphere", SceneObjects::sphere,
            "rectangle", SceneObjects::rectangle,
            "disk", SceneObjects::disk,
            "cylinder", SceneObjects::cylinder,
            "cone", SceneObjects::cone,
            "cube", SceneObjects::cube,
            "box", SceneObjects::box,
            "torus", SceneObjects::torus,
            "triangle", SceneObjects::triangle);

    private final Values values;
    private final Materials materials;
    private final Map<String, JsonValue> names = new HashMap<>();

    SceneObjects(Values values, Materials materials) {
        this.values = values;
        this.materials = materials;
    }

    /** The objects that have no problems. */
    List<SceneObject> read(JsonValue v, JsonPointer place) {
        JsonValue.Arr a = values.array(v, place, -1, "an array of objects");
        List<SceneObject> objects = new ArrayList<>(a == null ? 0 : a.size());
        for (int i = 0; a != null && i < a.size(); i++) {
            Fields f = Fields.of(a.get(i), place.child(i), FAMILY, null, values);
            SceneObject object = f == null ? null : object(f);
            if (object != null) {
                objects.add(object);
            }
        }
        return objects;
    }

    private SceneObject object(Fields f) {
        String name = name(f);
        Shape shape = SHAPES.get(f.type(null)).apply(f);
        List<Material> faces = faces(f);
        Material material = f.has("material") ? materials.use(f.get("material"), f.at("material")) : null;
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
            faces.add(materials.use(a.get(i), f.at("faces").child(i)));
        }
        return faces;
    }

    private static Shape sphere(Fields f) {
        ExactPoint center = f.point("center");
        double radius = f.number("radius");
        double rotation = f.number("rotation", 0);
        return f.make(() -> new Sphere(center, radius, rotation));
    }

    private static Shape rectangle(Fields f) {
        List<ExactPoint> c = f.points("corners", 4, CORNERS);
        return f.make(() -> new Rectangle(c.get(0), c.get(1), c.get(2), c.get(3)));
    }

    private static Shape disk(Fields f) {
        ExactPoint center = f.point("center");
        Vec3 normal = f.direction("normal", Vec3.Y);
        double radius = f.number("radius");
        return f.make(() -> new Disk(center, normal, radius));
    }

    private static Shape cylinder(Fields f) {
        ExactPoint base = f.point("base");
        ExactPoint top = f.point("top");
        double radius = f.number("radius");
        boolean capped = f.flag("capped", true);
        return f.make(() -> new Cylinder(base, top, radius, capped));
    }

    private static Shape cone(Fields f) {
        ExactPoint base = f.point("base");
        ExactPoint apex = f.point("apex");
        double radius = f.number("radius");
        double topRadius = f.number("topRadius", 0);
        boolean capped = f.flag("capped", true);
        return f.make(() -> new Cone(base, apex, radius, topRadius, capped));
    }

    private static Shape cube(Fields f) {
        ExactPoint center = f.point("center");
        double radius = f.number("radius");
        Vec3 rotation = f.angles("rotation", Vec3.ZERO);
        return f.make(() -> new Cube(center, radius, rotation));
    }

    private static Shape box(Fields f) {
        ExactPoint min = f.point("min");
        ExactPoint max = f.point("max");
        return f.make(() -> new Box(min, max));
    }

    private static Shape torus(Fields f) {
        ExactPoint center = f.point("center");
        Vec3 axis = f.direction("axis", Vec3.Y);
        double majorRadius = f.number("majorRadius");
        double minorRadius = f.number("minorRadius");
        return f.make(() -> new Torus(center, axis, majorRadius, minorRadius));
    }

    private static Shape triangle(Fields f) {
        List<ExactPoint> v = f.points("vertices", 3, "three vertices [x, y, z]");
        return f.make(() -> new Triangle(v.get(0), v.get(1), v.get(2)));
    }
}
