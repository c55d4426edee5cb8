package enlightenment.importer.support;

import enlightenment.geometry.Disk;
import enlightenment.geometry.Mesh;
import enlightenment.geometry.Rectangle;
import enlightenment.geometry.Shape;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import java.util.Optional;

/** The fronts of rectangles, disks and meshes: the sides that {@link enlightenment.material.Material.EmissionPattern.Side#FRONT} means. */
public final class Fronts {
    private Fronts() {}

    /** Whether a shape can be turned: its front is not the outside by definition. */
    public static boolean isTurnable(Shape shape) {
        return shape instanceof Rectangle || shape instanceof Disk || shape instanceof Mesh;
    }

    /** The normal on the front at {@link #point}, of any length; of a shape that {@link #isTurnable can be turned}. */
    public static Vec3 normal(Shape shape) {
        if (shape instanceof Rectangle r) {
            return ExactPoint.normal(r.lowerLeft(), r.upperLeft(), r.lowerRight());
        } else if (shape instanceof Disk d) {
            return d.normal();
        }
        Mesh m = (Mesh) shape;
        Vec3 a = corner(m, 0);
        return corner(m, 1).minus(a).cross(corner(m, 2).minus(a));
    }

    /** A point of such a shape: of a mesh, one of its first triangle. */
    public static Vec3 point(Shape shape) {
        if (shape instanceof Rectangle r) {
            return r.lowerLeft().toVec3();
        } else if (shape instanceof Disk d) {
            return d.center().toVec3();
        }
        return corner((Mesh) shape, 0);
    }

    private static Vec3 corner(Mesh m, int k) {
        return m.transform()
                .apply(m.triangles().position(m.triangles().vertex(0, k)))
                .toVec3();
    }

    /** Such a shape with its front where its back is. Texture coordinates of a rectangle are transposed; others stay. */
    public static Shape turned(Shape shape) {
        if (shape instanceof Rectangle r) {
            return new Rectangle(r.lowerLeft(), r.lowerRight(), r.upperRight(), r.upperLeft());
        } else if (shape instanceof Disk d) {
            return new Disk(d.center(), d.normal().negated(), d.radius());
        }
        Mesh m = (Mesh) shape;
        return new Mesh(m.triangles().turned(), Optional.empty(), m.transform());
    }
}
