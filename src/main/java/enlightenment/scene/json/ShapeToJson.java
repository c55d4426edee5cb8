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

/** Turns shapes into JSON. */
final class ShapeToJson {
    private ShapeToJson() {}

    /** Puts the shape's type and keys into an object's part. */
    static void put(Shape shape, JsonObjectBuilder p) {
        p.text("type", shape.type());
        if (shape instanceof Sphere s) {
            p.point("center", s.center()).number("radius", s.radius()).numberUnless(0, "rotation", s.rotation());
        } else if (shape instanceof Rectangle r) {
            p.points("corners", r.lowerLeft(), r.upperLeft(), r.upperRight(), r.lowerRight());
        } else if (shape instanceof Disk d) {
            p.point("center", d.center()).vector("normal", d.normal()).number("radius", d.radius());
        } else if (shape instanceof Cylinder c) {
            p.point("base", c.base()).point("top", c.top()).number("radius", c.radius());
            p.flagUnless(true, "capped", c.capped());
        } else if (shape instanceof Cone c) {
            p.point("base", c.base()).point("apex", c.apex()).number("radius", c.radius());
            p.numberUnless(0, "topRadius", c.topRadius()).flagUnless(true, "capped", c.capped());
        } else if (shape instanceof Cube c) {
            p.point("center", c.center()).number("radius", c.radius());
            p.vectorUnless(Vec3.ZERO, "rotation", c.rotation());
        } else if (shape instanceof Box b) {
            p.point("min", b.min()).point("max", b.max());
        } else if (shape instanceof Torus t) {
            p.point("center", t.center()).vector("axis", t.axis());
            p.number("majorRadius", t.majorRadius()).number("minorRadius", t.minorRadius());
        } else if (shape instanceof Triangle t) {
            p.points("vertices", t.a(), t.b(), t.c());
        }
    }
}
