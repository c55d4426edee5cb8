package enlightenment.primitive;

import enlightenment.frame.Parallelograms;
import enlightenment.frame.Rotation;
import enlightenment.frame.SceneFrame;
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
import enlightenment.math.Vec3;
import enlightenment.mesh.TriangleMesh;
import java.util.List;

/** Places shapes, which are exact descriptions, in a frame: makes primitives that rays can intersect. */
public final class Primitives {
    private static final CornerUv WITHOUT_UV = new CornerUv(0, 0, 1, 0, 0, 1);

    private static final Vec3 NOT_ROTATED = meridian(0);

    private Primitives() {}

    /** The primitives that a shape consists of, in a frame: each has its own place in the hierarchy and its own faces. */
    public static List<Primitive> placeAll(Shape shape, SceneFrame frame) {
        return List.of(place(shape, frame));
    }

    /** The primitive of a shape that is a single one. Every such kind has its line here, as a test checks. */
    public static Primitive place(Shape shape, SceneFrame frame) {
        if (shape instanceof Sphere s) {
            return sphere(s, frame);
        } else if (shape instanceof Triangle t) {
            return triangle(t, frame);
        } else if (shape instanceof Rectangle r) {
            return rectangle(r, frame);
        } else if (shape instanceof Box b) {
            return new BoxPrimitive(frame.toFrame(b.min()), frame.toFrame(b.max()));
        } else if (shape instanceof Cube c) {
            return cube(c, frame);
        } else if (shape instanceof Cylinder c) {
            return cylinder(c, frame);
        } else if (shape instanceof Cone c) {
            return cone(c, frame);
        } else if (shape instanceof Disk d) {
            return new DiskPrimitive(frame.toFrame(d.center()), d.normal(), Sizes.inFrame(d.radius(), frame));
        } else if (shape instanceof Torus t) {
            return torus(t, frame);
        }
        if (shape instanceof Mesh m) {
            return new MeshPrimitive(m.triangles(), Placing.of(m.transform(), frame));
        }
        throw new AssertionError("no primitive for the shape " + shape.type());
    }

    /** The triangles of a mesh, each as a primitive of its own, for sampling of lights. */
    public static List<Primitive> triangles(Mesh shape, SceneFrame frame) {
        TriangleMesh mesh = shape.triangles();
        Placing placing = Placing.of(shape.transform(), frame);
        Primitive[] all = new Primitive[mesh.triangles()];
        for (int t = 0; t < all.length; t++) {
            all[t] = new TrianglePrimitive(
                    null,
                    corner(mesh, t, 0, placing),
                    corner(mesh, t, 1, placing),
                    corner(mesh, t, 2, placing),
                    uv(mesh, t));
        }
        return List.of(all);
    }

    /** The texture coordinates of a mesh's triangle; those of one without any are as {@link MeshPrimitive#textureCoordinates} states. */
    private static CornerUv uv(TriangleMesh mesh, int triangle) {
        if (!mesh.hasUv()) {
            return WITHOUT_UV;
        }
        int p = mesh.vertex(triangle, 0);
        int q = mesh.vertex(triangle, 1);
        int r = mesh.vertex(triangle, 2);
        return new CornerUv(mesh.uv(p, 0), mesh.uv(p, 1), mesh.uv(q, 0), mesh.uv(q, 1), mesh.uv(r, 0), mesh.uv(r, 1));
    }

    private static Vec3 corner(TriangleMesh mesh, int triangle, int corner, Placing placing) {
        int v = mesh.vertex(triangle, corner);
        return placing.point(mesh.coordinate(v, 0), mesh.coordinate(v, 1), mesh.coordinate(v, 2));
    }

    private static Primitive sphere(Sphere s, SceneFrame frame) {
        // One object for all that are not rotated: a scene may have millions.
        Vec3 meridian = Double.compare(s.rotation(), 0) == 0 ? NOT_ROTATED : meridian(s.rotation());
        return new SpherePrimitive(frame.toFrame(s.center()), Sizes.inFrame(s.radius(), frame), meridian);
    }

    private static Vec3 meridian(double rotation) {
        return Rotation.aboutY(rotation).apply(new Vec3(0, 0, -1));
    }

    private static Primitive triangle(Triangle t, SceneFrame frame) {
        return new TrianglePrimitive(
                Parallelograms.normalIfDegenerate(t.a(), t.b(), t.c(), frame),
                frame.toFrame(t.a()),
                frame.toFrame(t.b()),
                frame.toFrame(t.c()));
    }

    private static Primitive rectangle(Rectangle r, SceneFrame frame) {
        return new RectanglePrimitive(
                Parallelograms.normalIfDegenerate(r.lowerLeft(), r.upperLeft(), r.lowerRight(), frame),
                frame.toFrame(r.lowerLeft()),
                frame.toFrame(r.upperLeft()),
                frame.toFrame(r.upperRight()),
                frame.toFrame(r.lowerRight()));
    }

    private static Primitive cube(Cube c, SceneFrame frame) {
        Vec3 middle = frame.toFrame(c.center());
        // The diagonal of a cube is sqrt(3) times its edge.
        double half = Sizes.inFrame(c.radius(), frame) / Math.sqrt(3);
        Rotation turn = Rotation.ofDegrees(c.rotation());
        return CubePrimitive.isUpright(turn) ? CubePrimitive.box(middle, half) : new CubePrimitive(middle, half, turn);
    }

    private static Primitive cylinder(Cylinder c, SceneFrame frame) {
        return new CylinderPrimitive(
                frame.toFrame(c.base()),
                frame.toFrame(c.top()),
                Axes.between(c.base(), c.top(), frame),
                Sizes.inFrame(c.radius(), frame),
                c.capped());
    }

    private static Primitive cone(Cone c, SceneFrame frame) {
        return new ConePrimitive(
                frame.toFrame(c.base()),
                frame.toFrame(c.apex()),
                Axes.between(c.base(), c.apex(), frame),
                Sizes.inFrame(c.radius(), frame),
                frame.toFrame(c.topRadius()),
                c.capped());
    }

    private static Primitive torus(Torus t, SceneFrame frame) {
        return new TorusPrimitive(
                frame.toFrame(t.center()),
                t.axis().normalized(),
                Sizes.inFrame(t.majorRadius(), frame),
                Sizes.inFrame(t.minorRadius(), frame));
    }
}
