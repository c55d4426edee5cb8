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
import enlightenment.scene.SceneObject;
import enlightenment.scene.Shading;
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

    /** Degrees: how far the lamp stands to the left of the eye, and how high. */
    private static final double LAMP_LEFT = 60;

    private static final double LAMP_ELEVATION = 50;

    /** Radii of the model's ball. */
    private static final double GROUND = 60;

    private static final double LAMP_DISTANCE = 4;
    private static final double LAMP_HALF = 1.4;

    private static final Rgb SKY = new Rgb(0.5, 0.52, 0.55);
    private static final Rgb LAMP = new Rgb(4.2, 4.1, 3.9);
    private static final Rgb FLOOR = new Rgb(0.55, 0.55, 0.55);

    private final double aspect;
    private final SceneImporter.Options.Up up;
    private final SceneImporter.Options.Orbit orbit;
    private Vec3 min = new Vec3(Double.MAX_VALUE, Double.MAX_VALUE, Double.MAX_VALUE);
    private Vec3 max = min.times(-1);

    /**
     * The studio around these objects.
     *
     * @param up the axis that points upwards
     * @param orbit where the eye is; the lamp stands to its left
     * @param aspect width of the picture divided by its height
     */
    Studio(List<SceneObject> objects, SceneImporter.Options.Up up, SceneImporter.Options.Orbit orbit, double aspect) {
        this.up = up;
        this.orbit = orbit;
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

    /** A direction from the model: degrees to the right of the front, and above the ground. */
    private Vec3 towards(double azimuth, double elevation) {
        double a = StrictMath.toRadians(azimuth);
        double e = StrictMath.toRadians(elevation);
        Vec3 across = up.right().times(StrictMath.sin(a) * StrictMath.cos(e));
        Vec3 ahead = up.front().times(StrictMath.cos(a) * StrictMath.cos(e));
        return across.plus(up.axis().times(StrictMath.sin(e))).plus(ahead);
    }

    /** Upwards in the picture: the axis, or, for an eye straight above or below, away from the azimuth that it came from. */
    private Vec3 top() {
        boolean isPole = Math.abs(orbit.elevation()) == 90;
        return isPole ? towards(orbit.azimuth(), 0).times(-Math.signum(orbit.elevation())) : up.axis();
    }

    /** The view of the orbit, so far that the corners of the box around the model lie within most of the picture. */
    Camera camera() {
        Vec3 away = towards(orbit.azimuth(), orbit.elevation());
        Vec3 right = top().cross(away).normalized();
        Vec3 top = away.cross(right);
        double tangent = StrictMath.tan(StrictMath.toRadians(FIELD_OF_VIEW / 2)) * FILLED;
        double distance = 0;
        for (int corner = 0; corner < 8; corner++) {
            Vec3 p = new Bounds(min, max).corner(corner).minus(middle());
            double across = Math.abs(p.dot(right)) / (tangent * aspect);
            distance = Math.max(distance, p.dot(away) + Math.max(across, Math.abs(p.dot(top)) / tangent));
        }
        Vec3 forward = away.times(-distance);
        return new ImportView(middle().minus(forward), forward, top(), right).pinhole(FIELD_OF_VIEW);
    }

    /** The soft light from everywhere. */
    static Shading.Background sky() {
        return new Shading.Background.Constant(SKY);
    }

    /** A clear sky, whose sun stands where the lamp would. Up must be y. */
    Shading.Background clearSky() {
        return Shading.Background.Sky.of(LAMP_ELEVATION, orbit.azimuth() - LAMP_LEFT);
    }

    /** Whether the eye is above the horizon, so that a ground would not hide the model. */
    boolean isSeenFromAbove() {
        return orbit.elevation() >= 0;
    }

    /** Adds the lamp: a square that faces the model. */
    void addLamp(ImportDraft draft) {
        double r = radius();
        Vec3 direction = towards(orbit.azimuth() - LAMP_LEFT, LAMP_ELEVATION);
        Vec3 center = middle().plus(direction.times(LAMP_DISTANCE * r));
        Vec3 a = direction.cross(up.axis()).normalized().times(LAMP_HALF * r);
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
    }

    /** Adds the ground that the model stands on. */
    void addGround(ImportDraft draft) {
        Vec3 u = up.axis();
        // The face of the box below the middle, to the last bit: it has the coordinate of the lowest vertex.
        Vec3 m = middle();
        Vec3 low = u.x() + u.y() + u.z() > 0 ? min : max;
        Vec3 foot = new Vec3(u.x() == 0 ? m.x() : low.x(), u.y() == 0 ? m.y() : low.y(), u.z() == 0 ? m.z() : low.z());
        draft.object(
                "ground", new Disk(Affine.exact(foot), u, GROUND * radius()), Material.Matte.of(Texture.of(FLOOR)));
    }
}
