package enlightenment.importer.mitsuba;

import enlightenment.camera.Camera;
import enlightenment.importer.support.Affine;
import enlightenment.importer.support.ImportView;
import enlightenment.math.Vec3;
import enlightenment.text.Plain;
import java.util.List;
import java.util.Locale;

/** Reads the sensor with its film. Mitsuba's sensors look along +z, with +y upwards and +x to the left in the picture. */
final class SensorReader {
    private static final int USUAL_WIDTH = 768;
    private static final int USUAL_HEIGHT = 576;
    private static final int LARGEST = 1 << 20;
    private static final double USUAL_FAR_CLIP = 10_000;

    private final SceneIndex scene;
    private final Affine world;

    /** The film: all of it, and what is cropped, in pixels from its upper left. */
    private record Film(int width, int height, int x, int y, int cropWidth, int cropHeight) {
        double aspect() {
            return (double) width / height;
        }

        boolean isCropped() {
            return cropWidth != width || cropHeight != height;
        }
    }

    SensorReader(SceneIndex scene, Affine world) {
        this.scene = scene;
        this.world = world;
    }

    /** Whether a sensor's rays are parallel. */
    static boolean isParallel(XmlElement sensor) {
        return sensor.type().equals("orthographic");
    }

    /** Adds a sensor's view and picture to the scene. */
    void add(XmlElement sensor) {
        Properties p = new Properties(sensor);
        p.ignore("near_clip", "far_clip", "focus_distance", "shutter_open", "shutter_close", "srf", "id");
        Film film = film(sensor);
        scene.draft().size(film.cropWidth(), film.cropHeight());
        ImportView view = ImportView.of(world.after(p.transform("to_world")), Vec3.Z, Vec3.Y, Vec3.X.times(-1));
        switch (sensor.type()) {
            case "perspective" -> scene.draft().camera(perspective(p, view, film));
            case "thinlens" -> scene.draft().camera(focused(p, perspective(p, view, film)));
            case "orthographic" -> scene.draft().camera(parallel(p, view, film));
            default -> scene.note(sensor, sensor.described() + " is left out");
        }
        scene.noteUnused(p);
    }

    private Film film(XmlElement sensor) {
        List<XmlElement> films = scene.inside(sensor, "film");
        if (films.isEmpty()) {
            return new Film(USUAL_WIDTH, USUAL_HEIGHT, 0, 0, USUAL_WIDTH, USUAL_HEIGHT);
        }
        Properties p = new Properties(films.get(0));
        int width = pixels(p, "width", USUAL_WIDTH);
        int height = pixels(p, "height", USUAL_HEIGHT);
        int x = p.whole("crop_offset_x", 0);
        int y = p.whole("crop_offset_y", 0);
        int w = p.has("crop_width") ? pixels(p, "crop_width", width) : width - x;
        int h = p.has("crop_height") ? pixels(p, "crop_height", height) : height - y;
        if (x < 0 || y < 0 || w < 1 || h < 1 || (long) x + w > width || (long) y + h > height) {
            throw films.get(0).failure("has a crop that does not lie in its " + width + " x " + height + " pixels");
        }
        return new Film(width, height, x, y, w, h);
    }

    private static int pixels(Properties p, String name, int otherwise) {
        int v = p.whole(name, otherwise);
        if (v < 1 || v > LARGEST) {
            throw p.element().failure(name + " must be 1.." + LARGEST + " pixels, not " + v);
        }
        return v;
    }

    private static Camera perspective(Properties p, ImportView view, Film film) {
        double x = halfWidth(p, film.aspect());
        double y = x / film.aspect();
        double shiftX = p.number("principal_point_offset_x", 0);
        double shiftY = p.number("principal_point_offset_y", 0);
        if (!film.isCropped() && shiftX == 0 && shiftY == 0) {
            return view.pinhole(StrictMath.toDegrees(2 * StrictMath.atan(y)));
        }
        double left = (double) film.x() / film.width() + shiftX;
        double upper = (double) film.y() / film.height() + shiftY;
        return view.window(
                x * (2 * left - 1),
                x * (2 * (left + (double) film.cropWidth() / film.width()) - 1),
                y * (1 - 2 * (upper + (double) film.cropHeight() / film.height())),
                y * (1 - 2 * upper));
    }

    /** A camera with a thin lens; one whose picture is shifted or cropped keeps its pinhole. */
    private Camera focused(Properties p, Camera camera) {
        double radius = p.number("aperture_radius", 0);
        double distance = p.number("focus_distance", p.number("far_clip", USUAL_FAR_CLIP));
        if (!(radius >= 0 && distance > 0 && radius / Camera.Lens.MOST_DISTANCES <= distance)) {
            throw p.element()
                    .failure("must have a focus_distance above 0, and an aperture_radius of 0 to "
                            + Camera.Lens.MOST_DISTANCES + " times that");
        }
        if (radius > 0 && camera instanceof Camera.Perspective perspective) {
            return perspective.withLens(Camera.Lens.round(radius, distance));
        }
        if (radius > 0) {
            scene.note(p.element(), "a lens before a shifted or cropped picture becomes a pinhole");
        }
        return camera;
    }

    /** The tangent of half of the horizontal angle of view. */
    static double halfWidth(Properties p, double aspect) {
        XmlElement e = p.element();
        if (!p.has("fov")) {
            String focal = p.text("focal_length", "50mm").strip().replaceFirst("mm$", "");
            // 35 mm film: the diagonal of 36 x 24 mm.
            return ofDiagonal(StrictMath.hypot(36, 24) / (2 * positive(e, Properties.number(e, focal))), aspect);
        }
        double fov = p.number("fov", 0);
        if (!(fov > 0 && fov < 180)) {
            throw e.failure("must have a fov between 0 and 180 degrees, not " + fov);
        }
        double t = StrictMath.tan(StrictMath.toRadians(fov / 2));
        String axis = p.text("fov_axis", "x").toLowerCase(Locale.ROOT);
        return switch (axis) {
            case "x" -> t;
            case "y" -> t * aspect;
            case "diagonal" -> ofDiagonal(t, aspect);
            case "smaller" -> aspect > 1 ? t * aspect : t;
            case "larger" -> aspect > 1 ? t : t * aspect;
            default -> throw e.failure("fov_axis must be x, y, diagonal, smaller or larger, not " + Plain.quoted(axis));
        };
    }

    private static double positive(XmlElement e, double v) {
        if (!(v > 0)) {
            throw e.failure("must have a focal length above 0");
        }
        return v;
    }

    private static double ofDiagonal(double tangent, double aspect) {
        return tangent / StrictMath.sqrt(1 + 1 / (aspect * aspect));
    }

    /** The picture is 2 wide in the sensor's coordinates. */
    private Camera parallel(Properties p, ImportView view, Film film) {
        XmlElement e = p.element();
        if (film.isCropped()) {
            scene.note(e, "the crop of an orthographic view is left out");
            scene.draft().size(film.width(), film.height());
        }
        return view.parallel(2 * view.right().length() / film.aspect());
    }
}
