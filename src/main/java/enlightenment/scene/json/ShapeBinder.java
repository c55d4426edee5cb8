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
import enlightenment.math.Check.InvalidValueException;
import enlightenment.math.Point;
import enlightenment.math.Vec3;

/** Reads the shape of an object; the keys of its type are checked here, too. */
final class ShapeBinder {
    static final String CORNERS = "four corners: lower left, upper left, upper right, lower right";
    private static final String[] TYPES = {
        "sphere", "rectangle", "disk", "cylinder", "cone", "cube", "box", "torus", "triangle"
    };

    private ShapeBinder() {}

    /** The shape, or null after a problem. */
    static Shape read(Fields f, Problems problems) {
        Node type = f.optional("type");
        if (type instanceof Node.Str && ((Node.Str) type).text.equals("mesh")) {
            problems.at(type, "shape \"mesh\" is not available yet; expected one of " + Values.list(TYPES));
            return null;
        }
        String kind = f.requiredWord("type", "a type of shape", TYPES);
        if (kind == null) {
            return null;
        }
        f.restart();
        try {
            switch (kind) {
                case "sphere":
                    return sphere(f.only("a sphere", "type", "name", "material", "center", "radius", "rotation"));
                case "rectangle":
                    return rectangle(f.only("a rectangle", "type", "name", "material", "corners"));
                case "disk":
                    return disk(f.only("a disk", "type", "name", "material", "center", "normal", "radius"));
                case "cylinder":
                    return cylinder(
                            f.only("a cylinder", "type", "name", "material", "base", "top", "radius", "capped"));
                case "cone":
                    return cone(f.only(
                            "a cone", "type", "name", "material", "base", "apex", "radius", "topRadius", "capped"));
                case "cube":
                    return cube(f.only("a cube", "type", "name", "material", "center", "radius", "rotation", "faces"));
                case "box":
                    return box(f.only("a box", "type", "name", "material", "min", "max"));
                case "torus":
                    return torus(f.only(
                            "a torus", "type", "name", "material", "center", "axis", "majorRadius", "minorRadius"));
                default:
                    return triangle(f.only("a triangle", "type", "name", "material", "vertices"));
            }
        } catch (InvalidValueException e) {
            f.refuse(e);
            return null;
        }
    }

    private static Shape sphere(Fields f) {
        Point center = f.point("center");
        double radius = f.number("radius");
        double rotation = f.number("rotation", 0);
        return f.sound() ? new Sphere(center, radius, rotation) : null;
    }

    private static Shape rectangle(Fields f) {
        Point[] c = f.points("corners", 4, CORNERS);
        return f.sound() ? new Rectangle(c[0], c[1], c[2], c[3]) : null;
    }

    private static Shape disk(Fields f) {
        Point center = f.point("center");
        Vec3 normal = f.direction("normal");
        double radius = f.number("radius");
        return f.sound() ? new Disk(center, normal, radius) : null;
    }

    private static Shape cylinder(Fields f) {
        Point base = f.point("base");
        Point top = f.point("top");
        double radius = f.number("radius");
        boolean capped = f.truth("capped", true);
        return f.sound() ? new Cylinder(base, top, radius, capped) : null;
    }

    private static Shape cone(Fields f) {
        Point base = f.point("base");
        Point apex = f.point("apex");
        double radius = f.number("radius");
        double topRadius = f.number("topRadius", 0);
        boolean capped = f.truth("capped", true);
        return f.sound() ? new Cone(base, apex, radius, topRadius, capped) : null;
    }

    private static Shape cube(Fields f) {
        Point center = f.point("center");
        double radius = f.number("radius");
        Vec3 rotation = f.has("rotation") ? f.direction("rotation") : Vec3.ZERO;
        return f.sound() ? new Cube(center, radius, rotation) : null;
    }

    private static Shape box(Fields f) {
        Point min = f.point("min");
        Point max = f.point("max");
        return f.sound() ? new Box(min, max) : null;
    }

    private static Shape torus(Fields f) {
        Point center = f.point("center");
        Vec3 axis = f.direction("axis");
        double majorRadius = f.number("majorRadius");
        double minorRadius = f.number("minorRadius");
        return f.sound() ? new Torus(center, axis, majorRadius, minorRadius) : null;
    }

    private static Shape triangle(Fields f) {
        Point[] v = f.points("vertices", 3, "three vertices");
        return f.sound() ? new Triangle(v[0], v[1], v[2]) : null;
    }
}
