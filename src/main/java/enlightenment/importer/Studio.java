package enlightenment.importer;

import enlightenment.camera.Camera;
import enlightenment.color.Rgb;
import enlightenment.frame.Bounds;
import enlightenment.geometry.Disk;
import enlightenment.geometry.Mesh;
import enlightenment.geometry.Shape;
import enlightenment.importer.support.Affine;
import enlightenment.importer.support.ImportDraft;
import enlightenment.importer.support.ImportView;
import enlightenment.light.Emission;
import enlightenment.light.Light;
import enlightenment.material.Material;
import enlightenment.material.Texture;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.scene.Background;
import enlightenment.scene.SceneObject;
import java.util.List;

/**
 * Where models stand that come without a camera or light: seen from three quarters and somewhat above, on a wide ground, between soft light from
 * everywhere and a large lamp. The radiances are such that a white surface that faces upwards shows as nearly white.
 */
final class Studio {
    static final int WIDTH = 960;
    static final int HEIGHT = 720;

    /** Degrees: the view's height, how far it looks down, and how far it stands to the right of the front. */
    private static final double FIELD_OF_VIEW = 30;

    /** How much of the picture the model's box fills at most, from its middle. */
    private static final double FILLED = 0.85;

    private static final double ELEVATION = 22;
    private static final double AZIMUTH = 35;

    /** Radii of the model's ball. */
    private static final double GROUND = 60;

    private static final double LAMP_DISTANCE = 4;
    private static final double LAMP_HALF = 1.4;

    private static final Rgb SKY = new Rgb(0.5, 0.52, 0.55);
    private static final Rgb LAMP = new Rgb(4.2, 4.1, 3.9);
    private static final Rgb FLOOR = new Rgb(0.55, 0.55, 0.55);

    private final double aspect;
    private final boolean isUpZ;
    private Vec3 min = new Vec3(Double.MAX_VALUE, Double.MAX_VALUE, Double.MAX_VALUE);
    private Vec3 max = min.times(-1);

    /**
     * The studio around these objects.
     *
     * @param isUpZ whether z points upwards, else y
     * @param aspect width of the picture divided by its height
     */
    Studio(List<SceneObject> objects, boolean isUpZ, double aspect) {
        this.isUpZ = isUpZ;
        this.aspect = aspect;
        objects.forEach(o -> include(o.shape()));
    }

    private void include(Shape shape) {
        if (shape instanceof Mesh mesh) {
            Vec3 a = mesh.triangles().min();
            Vec3 b = mesh.triangles().max();
            for (int corner = 0; corner < 8; corner++) {
                include(
                        mesh.transform()
                                .apply(ExactPoint.of(
                                        (corner & 1) == 0 ? a.x() : b.x(),
                                        (corner & 2) == 0 ? a.y() : b.y(),
                                        (corner & 4) == 0 ? a.z() : b.z())),
                        0);
            }
        } else {
            shape.anchors().forEach(p -> include(p, shape.reach()));
        }
    }

    private void include(ExactPoint exact, double reach) {
        Vec3 p = exact.toVec3();
        Vec3 r = new Vec3(reach, reach, reach);
        min = new Vec3(
                Math.min(min.x(), p.x() - reach), Math.min(min.y(), p.y() - reach), Math.min(min.z(), p.z() - reach));
        Vec3 q = p.plus(r);
        max = new Vec3(Math.max(max.x(), q.x()), Math.max(max.y(), q.y()), Math.max(max.z(), q.z()));
    }

    private Vec3 middle() {
        return min.times(0.5).plus(max.times(0.5));
    }

    /** Of the ball around the box: never 0, since no shape is a point. */
    private double radius() {
        return max.minus(min).times(0.5).length();
    }

    private Vec3 up() {
        return isUpZ ? Vec3.Z : Vec3.Y;
    }

    /** A direction from the model: degrees to the right of the front, and above the ground. */
    private Vec3 towards(double azimuth, double elevation) {
        double a = StrictMath.toRadians(azimuth);
        double e = StrictMath.toRadians(elevation);
        double right = StrictMath.sin(a) * StrictMath.cos(e);
        double front = StrictMath.cos(a) * StrictMath.cos(e);
        double high = StrictMath.sin(e);
        // Models look towards +z where y points upwards, and towards -y where z does; both are right-handed.
        return isUpZ ? new Vec3(right, -front, high) : new Vec3(right, high, front);
    }

    /** From three quarters, so far that the corners of the box around the model lie within most of the picture. */
    Camera camera() {
        Vec3 away = towards(AZIMUTH, ELEVATION);
        Vec3 right = up().cross(away).normalized();
        Vec3 top = away.cross(right);
        double tangent = StrictMath.tan(StrictMath.toRadians(FIELD_OF_VIEW / 2)) * FILLED;
        double distance = 0;
        for (int corner = 0; corner < 8; corner++) {
            Vec3 p = new Bounds(min, max).corner(corner).minus(middle());
            double across = Math.abs(p.dot(right)) / (tangent * aspect);
            distance = Math.max(distance, p.dot(away) + Math.max(across, Math.abs(p.dot(top)) / tangent));
        }
        Vec3 forward = away.times(-distance);
        return new ImportView(middle().minus(forward), forward, up(), right).pinhole(FIELD_OF_VIEW);
    }

    /**
     * Adds light to a scene that has none.
     *
     * @param withGround whether there is to be a ground, too
     */
    void light(ImportDraft draft, boolean withGround) {
        draft.background(new Background.Constant(SKY));
        double r = radius();
        Vec3 direction = towards(AZIMUTH - 60, 50);
        Vec3 center = middle().plus(direction.times(LAMP_DISTANCE * r));
        Vec3 a = direction.cross(up()).normalized().times(LAMP_HALF * r);
        Vec3 b = direction.cross(a).normalized().times(LAMP_HALF * r);
        // (upperLeft − lowerLeft) × (lowerRight − lowerLeft) points to the side that shines: b × a is towards the
        // model.
        draft.light(new Light.Rectangle(
                Affine.exact(center.minus(a).minus(b)),
                Affine.exact(center.minus(a).plus(b)),
                Affine.exact(center.plus(a).plus(b)),
                Affine.exact(center.plus(a).minus(b)),
                Rgb.WHITE,
                false,
                Emission.radiance(LAMP)));
        if (withGround) {
            Vec3 m = middle();
            Vec3 foot = isUpZ ? new Vec3(m.x(), m.y(), min.z()) : new Vec3(m.x(), min.y(), m.z());
            draft.object(
                    "ground", new Disk(Affine.exact(foot), up(), GROUND * r), Material.Matte.of(Texture.of(FLOOR)));
        }
    }
}
