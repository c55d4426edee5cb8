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
import enlightenment.math.Vec3;
import java.util.Map;

/** Writes the keys of a shape, "type" aside. */
final class ShapeText {
    private ShapeText() {}

    /**
     * Adds the shape's keys.
     *
     * @param full whether numbers that have their default value are written, too
     */
    static void write(Shape shape, boolean full, Map<String, Object> to) {
        if (shape instanceof Sphere s) {
            to.put("center", Tokens.point(s.center()));
            to.put("radius", Tokens.number(s.radius()));
            optional(to, "rotation", s.rotation(), full);
        } else if (shape instanceof Rectangle r) {
            to.put("corners", Tokens.points(r.lowerLeft(), r.upperLeft(), r.upperRight(), r.lowerRight()));
        } else if (shape instanceof Disk d) {
            to.put("center", Tokens.point(d.center()));
            to.put("normal", Tokens.vector(d.normal()));
            to.put("radius", Tokens.number(d.radius()));
        } else if (shape instanceof Cylinder c) {
            to.put("base", Tokens.point(c.base()));
            to.put("top", Tokens.point(c.top()));
            to.put("radius", Tokens.number(c.radius()));
            capped(to, c.capped());
        } else if (shape instanceof Cone c) {
            to.put("base", Tokens.point(c.base()));
            to.put("apex", Tokens.point(c.apex()));
            to.put("radius", Tokens.number(c.radius()));
            optional(to, "topRadius", c.topRadius(), full);
            capped(to, c.capped());
        } else if (shape instanceof Triangle t) {
            to.put("vertices", Tokens.points(t.a(), t.b(), t.c()));
        } else {
            solid(shape, full, to);
        }
    }

    private static void solid(Shape shape, boolean full, Map<String, Object> to) {
        if (shape instanceof Cube c) {
            to.put("center", Tokens.point(c.center()));
            to.put("radius", Tokens.number(c.radius()));
            if (full || !c.rotation().equals(Vec3.ZERO)) {
                to.put("rotation", Tokens.vector(c.rotation()));
            }
        } else if (shape instanceof Box b) {
            to.put("min", Tokens.point(b.min()));
            to.put("max", Tokens.point(b.max()));
        } else if (shape instanceof Torus t) {
            to.put("center", Tokens.point(t.center()));
            to.put("axis", Tokens.vector(t.axis()));
            to.put("majorRadius", Tokens.number(t.majorRadius()));
            to.put("minorRadius", Tokens.number(t.minorRadius()));
        } else {
            throw new IllegalStateException("no text for the shape " + shape.type());
        }
    }

    private static void optional(Map<String, Object> to, String key, double value, boolean full) {
        // By comparison of the bits: -0.0 must come back as -0.0.
        if (full || Double.compare(value, 0.0) != 0) {
            to.put(key, Tokens.number(value));
        }
    }

    private static void capped(Map<String, Object> to, boolean capped) {
        if (!capped) {
            to.put("capped", "false");
        }
    }
}
