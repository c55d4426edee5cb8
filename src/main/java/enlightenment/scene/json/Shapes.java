package enlightenment.scene.json;

import enlightenment.geometry.Box;
import enlightenment.geometry.Cone;
import enlightenment.geometry.Cube;
import enlightenment.geometry.Cylinder;
import enlightenment.geometry.Disk;
import enlightenment.geometry.Mesh;
import enlightenment.geometry.Rectangle;
import enlightenment.geometry.Shape;
import enlightenment.geometry.Sphere;
import enlightenment.geometry.Torus;
import enlightenment.geometry.Triangle;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import java.util.List;
import java.util.Map;

/** Reads and writes the shapes of objects. */
final class Shapes {
    static final String CORNERS = "four corners [x, y, z]: lower left, upper left, upper right, lower right";

    /** The kinds of shapes. Their keys {@code material} and {@code name} belong to the object. */
    static final Family<Shape> FAMILY = new Family<Shape>(
                    "object", "an object of the scene", null, Map.of(), Shapes::read, Shapes::write)
            .with("sphere", Sphere.class, "center radius material | rotation name")
            .with("rectangle", Rectangle.class, "corners material | name")
            .with("disk", Disk.class, "center normal radius material | name")
            .with("cylinder", Cylinder.class, "base top radius material | capped name")
            .with("cone", Cone.class, "base apex radius material | topRadius capped name")
            .with(
                    "cube",
                    Cube.class,
                    // The material of a cube may be missing where it has faces.
                    "center radius | rotation faces material name")
            .with("box", Box.class, "min max material | name")
            .with("torus", Torus.class, "center axis majorRadius minorRadius material | name")
            .with("triangle", Triangle.class, "vertices material | name")
            .with("mesh", Mesh.class, "material | mesh file part normals crease transform name");

    private Shapes() {}

    private static Shape read(String type, Fields f) {
        return switch (type) {
            case "sphere" -> sphere(f);
            case "rectangle" -> rectangle(f);
            case "disk" -> disk(f);
            case "cylinder" -> cylinder(f);
            case "cone" -> cone(f);
            case "cube" -> cube(f);
            case "box" -> box(f);
            case "torus" -> torus(f);
            case "triangle" -> triangle(f);
            case "mesh" -> Meshes.shape(f);
            default -> throw Family.unknown(type);
        };
    }

    private static void write(Shape value, JsonObjectBuilder p) {
        if (value instanceof Sphere s) {
            p.point("center", s.center()).number("radius", s.radius()).numberUnless(0, "rotation", s.rotation());
        } else if (value instanceof Rectangle r) {
            p.points("corners", r.lowerLeft(), r.upperLeft(), r.upperRight(), r.lowerRight());
        } else if (value instanceof Disk d) {
            p.point("center", d.center()).vector("normal", d.normal()).number("radius", d.radius());
        } else if (value instanceof Cylinder c) {
            p.point("base", c.base())
                    .point("top", c.top())
                    .number("radius", c.radius())
                    .flagUnless(true, "capped", c.capped());
        } else if (value instanceof Cone c) {
            p.point("base", c.base())
                    .point("apex", c.apex())
                    .number("radius", c.radius())
                    .numberUnless(0, "topRadius", c.topRadius())
                    .flagUnless(true, "capped", c.capped());
        } else if (value instanceof Cube c) {
            p.point("center", c.center())
                    .number("radius", c.radius())
                    .vectorUnless(Vec3.ZERO, "rotation", c.rotation());
        } else if (value instanceof Box b) {
            p.point("min", b.min()).point("max", b.max());
        } else if (value instanceof Torus t) {
            p.point("center", t.center())
                    .vector("axis", t.axis())
                    .number("majorRadius", t.majorRadius())
                    .number("minorRadius", t.minorRadius());
        } else if (value instanceof Triangle t) {
            p.points("vertices", t.a(), t.b(), t.c());
        } else if (value instanceof Mesh m) {
            Meshes.write(m, p);
        } else {
            throw Family.unknown(value);
        }
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
