package enlightenment.importer.pbrt;

import enlightenment.camera.Camera;
import enlightenment.importer.support.Affine;
import enlightenment.importer.support.ImportDraft;
import enlightenment.importer.support.ImportNotes;
import enlightenment.importer.support.ImportView;
import enlightenment.math.InvalidValueException;
import enlightenment.math.Vec3;
import enlightenment.text.Plain;
import java.util.Optional;

/** The camera and the film: which rays there are, and how bright they show. */
final class Views {
    private static final int USUAL_WIDTH = 1280;
    private static final int USUAL_HEIGHT = 720;
    private static final int LARGEST = 1 << 16;
    private static final double USUAL_FIELD = 90;

    private static final double USUAL_FOCUS = 1e6;

    /** Of a camera whose lenses are not read: about that of a normal lens. */
    private static final double REALISTIC_FIELD = 40;

    private final ImportNotes notes;
    private String type = "";
    private Parameters camera;
    private Affine toWorld;
    private Parameters film;

    Views(ImportNotes notes) {
        this.notes = notes;
    }

    /** @param toCamera the current transformation matrix where the camera stands */
    void camera(String kind, Parameters parameters, Affine toCamera) {
        type = kind;
        camera = parameters;
        try {
            toWorld = toCamera.inverse();
        } catch (IllegalArgumentException e) {
            throw parameters.place().failure("the camera's transformation: " + e.getMessage());
        }
    }

    void film(Parameters parameters) {
        film = parameters;
    }

    /** From the camera's coordinates to those of the world; the identity before there is a camera. */
    Affine cameraToWorld() {
        return toWorld == null ? Affine.IDENTITY : toWorld;
    }

    /** Gives the scene its size, camera and exposure. */
    void addTo(ImportDraft draft, Place start) {
        Parameters f = film == null ? new Parameters(start) : film;
        Parameters c = camera == null ? new Parameters(start) : camera;
        int width = f.integer("xresolution", USUAL_WIDTH, 1, LARGEST);
        int height = f.integer("yresolution", USUAL_HEIGHT, 1, LARGEST);
        double[] crop = type.equals("spherical") ? whole(f) : crop(f, width, height);
        int x0 = (int) StrictMath.ceil(width * crop[0]);
        int x1 = (int) StrictMath.ceil(width * crop[1]);
        int y0 = (int) StrictMath.ceil(height * crop[2]);
        int y1 = (int) StrictMath.ceil(height * crop[3]);
        if (x1 <= x0 || y1 <= y0) {
            throw f.place().failure("the film's crop window holds no pixel");
        }
        draft.size(x1 - x0, y1 - y0);
        expose(draft, f, c);
        double aspect = c.number("frameaspectratio", (double) width / height);
        double[] screen = screen(c, aspect);
        double[] window = {
            mix(screen, 0, (double) x0 / width),
            mix(screen, 0, (double) x1 / width),
            mix(screen, 2, 1 - (double) y1 / height),
            mix(screen, 2, 1 - (double) y0 / height)
        };
        draft.camera(placed(c, window, (double) (x1 - x0) / (y1 - y0)));
    }

    /** All of the picture: panoramas have no crop. */
    private double[] whole(Parameters f) {
        if (f.has("cropwindow") || f.has("pixelbounds")) {
            notes.add(f.place().shown(), "the crop of a spherical camera is left out");
        }
        return new double[] {0, 1, 0, 1};
    }

    private static double mix(double[] screen, int first, double t) {
        return t == 1 ? screen[first + 1] : screen[first] + t * (screen[first + 1] - screen[first]);
    }

    /** Shares of the picture: left, right, top, bottom. */
    private static double[] crop(Parameters f, int width, int height) {
        double[] shares = {0, 1, 0, 1};
        if (f.has("cropwindow")) {
            shares = f.tuples("cropwindow", 4).clone();
        } else if (f.has("pixelbounds")) {
            int[] b = f.integers("pixelbounds");
            shares = b.length == 4
                    ? new double[] {
                        (double) b[0] / width, (double) b[1] / width, (double) b[2] / height, (double) b[3] / height
                    }
                    : new double[0];
        }
        if (shares.length != 4) {
            throw f.place().failure("a crop must be four numbers: x from, x to, y from, y to");
        }
        for (int i = 0; i < shares.length; i++) {
            shares[i] = Math.min(1, Math.max(0, shares[i]));
        }
        return shares;
    }

    /** Left, right, bottom and top of the picture in pbrt's screen space, whose shorter side reaches from −1 to 1. */
    private static double[] screen(Parameters c, double aspect) {
        if (c.has("screenwindow")) {
            double[] s = c.tuples("screenwindow", 4);
            if (s.length != 4 || !(s[1] > s[0]) || !(s[3] > s[2])) {
                throw c.place().failure("a screen window must be four numbers: x from, x to, y from, y to");
            }
            return s;
        }
        if (!(aspect > 0) || aspect == Double.POSITIVE_INFINITY) {
            throw c.place().failure("an aspect ratio must be greater than 0, not " + aspect);
        }
        return aspect > 1 ? new double[] {-aspect, aspect, -1, 1} : new double[] {-1, 1, -1 / aspect, 1 / aspect};
    }

    /** The imaging ratio of the film's sensor: exposure time times ISO / 100. */
    private void expose(ImportDraft draft, Parameters f, Parameters c) {
        double time = c.number("shutterclose", 1) - c.number("shutteropen", 0);
        double ratio = time * f.positive("iso", 100) / 100;
        if (!(ratio > 0)) {
            throw c.place().failure("the shutter must close after it opens");
        }
        if (ratio != 1) {
            draft.exposure(StrictMath.log(ratio) / StrictMath.log(2));
        }
        if (!f.string("sensor", "cie1931").equals("cie1931")) {
            notes.add(
                    f.place().shown(),
                    "the film's sensor " + Plain.quoted(f.string("sensor", "")) + " is replaced by that of CIE 1931");
        }
        if (f.number("whitebalance", 0) != 0) {
            notes.add(f.place().shown(), "the white balance is left out");
        }
    }

    private Camera placed(Parameters c, double[] window, double aspect) {
        // The camera's coordinates: x to the right, y up, z along the view.
        ImportView view = ImportView.of(cameraToWorld(), Vec3.Z, Vec3.Y, Vec3.X);
        switch (type) {
            case "perspective", "":
                return perspective(view, window, aspect, field(c), lens(c));
            case "realistic":
                notes.add(c.place().shown(), "a realistic camera becomes a pinhole of 40 degrees");
                return perspective(view, window, aspect, REALISTIC_FIELD, Optional.empty());
            case "spherical":
                return panorama(c);
            case "orthographic":
                return orthographic(view, window);
            default:
                throw c.place().failure("pbrt-v4 has no camera of the kind " + Plain.quoted(type));
        }
    }

    /** @param degrees the angle of view of the screen from -1 to 1 */
    private Camera perspective(
            ImportView view, double[] window, double aspect, double degrees, Optional<Camera.Lens> lens) {
        double half = StrictMath.tan(StrictMath.toRadians(degrees / 2));
        double right = window[1];
        double top = window[3];
        boolean isCentred = isEqual(-window[0], right) && isEqual(-window[2], top) && isEqual(right, aspect * top);
        if (!isCentred) {
            lens.ifPresent(l -> notes.add(
                    camera.place().shown(),
                    "the blur of a lens is left out, whose axis is not in the picture's middle"));
            return view.window(half * window[0], half * right, half * window[2], half * top);
        }
        Camera.Perspective pinhole;
        if (top == 1) {
            pinhole = view.pinhole(degrees);
        } else if (right == 1) {
            pinhole = view.pinhole(degrees).withAxis(Camera.FieldOfViewAxis.HORIZONTAL);
        } else {
            pinhole = view.pinhole(StrictMath.toDegrees(2 * StrictMath.atan(half * top)));
        }
        return lens.<Camera>map(pinhole::withLens).orElse(pinhole);
    }

    /** Whether two numbers differ by no more than the rounding of the few operations that they come from. */
    private static boolean isEqual(double a, double b) {
        return Math.abs(a - b) <= 8 * Math.ulp(Math.max(Math.abs(a), Math.abs(b)));
    }

    /** The lens in units of the scene. */
    private Optional<Camera.Lens> lens(Parameters c) {
        double radius = cameraToWorld().vector(Vec3.X).length() * c.number("lensradius", 0);
        if (!(radius > 0)) {
            return Optional.empty();
        }
        double focus = cameraToWorld().vector(Vec3.Z).length() * c.positive("focaldistance", USUAL_FOCUS);
        try {
            return Optional.of(Camera.Lens.round(radius, focus));
        } catch (InvalidValueException e) {
            throw c.place().failure("the camera's lens: " + e.getMessage());
        }
    }

    /** pbrt's equirectangular picture has -x in its middle, and -z to the right of that. */
    private Camera panorama(Parameters c) {
        String mapping = c.string("mapping", "equalarea");
        if (!mapping.equals("equirectangular")) {
            notes.add(c.place().shown(), "a spherical camera of equal areas becomes one by longitude and latitude");
        }
        return ImportView.of(cameraToWorld(), Vec3.X.negated(), Vec3.Y, Vec3.Z.negated())
                .panorama();
    }

    private static double field(Parameters c) {
        double degrees = c.number("fov", USUAL_FIELD);
        if (!(degrees > 0 && degrees < 180)) {
            throw c.place().failure("a field of view must be an angle between 0 and 180 degrees, not " + degrees);
        }
        return degrees;
    }

    private Camera orthographic(ImportView view, double[] window) {
        Affine map = cameraToWorld();
        Vec3 middle = new Vec3((window[0] + window[1]) / 2, (window[2] + window[3]) / 2, 0);
        Vec3 eye = map.point(middle);
        return new ImportView(eye, view.forward(), view.up(), view.right())
                .parallel(map.vector(new Vec3(0, window[3] - window[2], 0)).length());
    }
}
