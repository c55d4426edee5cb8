package enlightenment.importer.support;

import enlightenment.color.Rgb;
import enlightenment.geometry.Box;
import enlightenment.geometry.Cylinder;
import enlightenment.geometry.Disk;
import enlightenment.geometry.Mesh;
import enlightenment.geometry.Rectangle;
import enlightenment.geometry.Shape;
import enlightenment.geometry.Sphere;
import enlightenment.light.Emission;
import enlightenment.light.Light;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import java.util.ArrayList;
import java.util.List;

/**
 * Shapes of unit size under any affine map. What the map leaves a shape of the same kind stays one; else it becomes triangles, with a note.
 *
 * <p>Files print matrices with six digits or as floats: a map counts as a similarity where it is one to that precision.
 */
public final class PlacedShapes {
    /** Six printed digits of a number that begins with 1 are exact to 5e-6 of it; products of two of them to twice that. */
    private static final double PRINTED = 0x1p-16;

    private final ImportNotes notes;

    /** 1 if v grows upwards in textures, else −1. */
    private final int up;

    /**
     * @param notes where approximations are noted
     * @param isVDown whether v = 0 is the upper edge of textures in the format, as in Mitsuba and glTF
     */
    public PlacedShapes(ImportNotes notes, boolean isVDown) {
        this.notes = notes;
        up = isVDown ? -1 : 1;
    }

    /**
     * The square −1..1 of the xy plane: a parallelogram under every map. u of its texture grows with x, v with y.
     *
     * @throws enlightenment.math.InvalidValueException if the map leaves no area
     */
    public Rectangle rectangle(Affine map) {
        return face(map, new Vec3(0, 0, 0), Vec3.X, Vec3.Y.times(up));
    }

    /** The parallelogram middle ± right ± up, mapped; its corners are exact sums, so that neighbours share them. */
    private static Rectangle face(Affine map, Vec3 middle, Vec3 right, Vec3 up) {
        ExactPoint m = sum(Affine.exact(map.offset()), Affine.exact(map.vector(middle)), 1);
        ExactPoint r = Affine.exact(map.vector(right));
        ExactPoint u = Affine.exact(map.vector(up));
        return new Rectangle(
                sum(sum(m, r, -1), u, -1), sum(sum(m, r, -1), u, 1), sum(sum(m, r, 1), u, 1), sum(sum(m, r, 1), u, -1));
    }

    private static ExactPoint sum(ExactPoint p, ExactPoint q, int sign) {
        return sign > 0
                ? new ExactPoint(p.x().add(q.x()), p.y().add(q.y()), p.z().add(q.z()))
                : new ExactPoint(p.x().subtract(q.x()), p.y().subtract(q.y()), p.z().subtract(q.z()));
    }

    /**
     * The parallelogram as a light that shines to one side.
     *
     * @param front a direction to that side
     */
    public static Light.Rectangle oneSided(Rectangle r, Vec3 front, Rgb radiance) {
        boolean isFront =
                ExactPoint.normal(r.lowerLeft(), r.upperLeft(), r.lowerRight()).dot(front) > 0;
        return new Light.Rectangle(
                r.lowerLeft(),
                isFront ? r.upperLeft() : r.lowerRight(),
                r.upperRight(),
                isFront ? r.lowerRight() : r.upperLeft(),
                Rgb.WHITE,
                false,
                Emission.radiance(radiance));
    }

    /**
     * The ball of radius 1 about the origin.
     *
     * @param isTextured whether its texture counts, whose poles are on the z axis, the upper edge at +z: such a ball becomes triangles
     */
    public Shape sphere(Affine map, boolean isTextured, String place) {
        if (!isTextured && isSimilarity(map)) {
            return Sphere.of(Affine.exact(map.offset()), StrictMath.cbrt(StrictMath.abs(map.determinant())));
        }
        notes.add(place, "a " + (isTextured ? "textured" : "stretched") + " sphere becomes triangles");
        return Mesh.of(ShapeMeshes.SPHERE, map.transform());
    }

    /**
     * The disk of radius 1 about the origin in the xy plane.
     *
     * @param isTextured whether its texture counts, by radius and angle: such a disk becomes triangles
     */
    public Shape disk(Affine map, boolean isTextured, String place) {
        Vec3 a = map.column(0);
        Vec3 b = map.column(1);
        if (!isTextured && isRound(a, b)) {
            Vec3 normal = a.cross(b);
            return new Disk(Affine.exact(map.offset()), normal, StrictMath.sqrt(normal.length()));
        }
        notes.add(place, "a " + (isTextured ? "textured" : "stretched") + " disk becomes triangles");
        return Mesh.of(up > 0 ? ShapeMeshes.DISK : ShapeMeshes.DISK_DOWN, map.transform());
    }

    /**
     * The cylinder of radius 1 about the z axis from 0 to 1, without caps.
     *
     * @param isTextured whether its texture counts, around and along: such a cylinder becomes triangles
     */
    public Shape cylinder(Affine map, boolean isTextured, String place) {
        Vec3 a = map.column(0);
        Vec3 b = map.column(1);
        Vec3 axis = map.column(2);
        if (!isTextured && isRound(a, b) && areSquare(a, axis) && areSquare(b, axis)) {
            return new Cylinder(
                    Affine.exact(map.offset()),
                    sum(Affine.exact(map.offset()), Affine.exact(axis), 1),
                    StrictMath.sqrt(a.cross(b).length()),
                    false);
        }
        notes.add(place, "a " + (isTextured ? "textured" : "stretched") + " cylinder becomes triangles");
        return Mesh.of(up > 0 ? ShapeMeshes.CYLINDER : ShapeMeshes.CYLINDER_DOWN, map.transform());
    }

    /**
     * The cube −1..1: a box where the map keeps the axes, else six parallelograms, or one mesh where a solid is needed.
     *
     * @param isTextured whether its texture counts, which shows on each face whole, with Mitsuba's directions
     * @param isSolid whether glass or a medium fills it
     */
    public static List<Shape> cube(Affine map, boolean isTextured, boolean isSolid) {
        if (!isTextured && keepsAxes(map)) {
            Vec3 h = new Vec3(map.x().maxAbs(), map.y().maxAbs(), map.z().maxAbs());
            ExactPoint middle = Affine.exact(map.offset());
            return List.of(new Box(sum(middle, Affine.exact(h), -1), sum(middle, Affine.exact(h), 1)));
        }
        if (isSolid) {
            return List.of(Mesh.of(ShapeMeshes.CUBE, map.transform()));
        }
        List<Shape> faces = new ArrayList<>();
        for (ShapeMeshes.CubeFace f : ShapeMeshes.CUBE_FACES) {
            faces.add(face(map, f.out(), f.right(), f.up()));
        }
        return faces;
    }

    /** Whether a map keeps the shape of everything, to the precision of printed matrices. */
    public static boolean isSimilarity(Affine map) {
        Vec3 a = map.column(0);
        Vec3 b = map.column(1);
        Vec3 c = map.column(2);
        return isRound(a, b) && isRound(b, c) && areSquare(a, c);
    }

    private static boolean isRound(Vec3 a, Vec3 b) {
        double p = a.length();
        double q = b.length();
        return p > 0 && StrictMath.abs(p - q) <= PRINTED * p && areSquare(a, b);
    }

    private static boolean areSquare(Vec3 a, Vec3 b) {
        return StrictMath.abs(a.dot(b)) <= PRINTED * a.length() * b.length() && a.length() > 0 && b.length() > 0;
    }

    private static boolean keepsAxes(Affine map) {
        return hasOne(map.x())
                && hasOne(map.y())
                && hasOne(map.z())
                && hasOne(map.column(0))
                && hasOne(map.column(1))
                && hasOne(map.column(2));
    }

    private static boolean hasOne(Vec3 v) {
        return (v.x() != 0 ? 1 : 0) + (v.y() != 0 ? 1 : 0) + (v.z() != 0 ? 1 : 0) == 1;
    }
}
