package enlightenment.camera;

import enlightenment.check.Check;
import enlightenment.frame.Parallelograms;
import enlightenment.math.ExactPoint;
import enlightenment.math.InvalidValueException;
import enlightenment.math.Vec3;
import java.util.List;
import java.util.Objects;
import java.util.Optional;

/**
 * Where the picture is seen from: an immutable description in scene coordinates and scene units, exact, validated when it is
 * made.
 *
 * <p>The constructors throw {@link InvalidValueException}, with the key of the scene format, for a value out of range or a
 * degenerate view, and {@link NullPointerException} for a missing value. Angles are degrees.
 */
public sealed interface Camera
        permits Camera.Window, Camera.Perspective, Camera.Orthographic, Camera.Isometric, Camera.Panorama {

    /** The name of this kind of camera in the scene format, such as {@code "window"}. */
    String type();

    /** The point that becomes the origin of the frame that the scene is rendered in. */
    ExactPoint origin();

    /** The points that define where rays start, at least one. */
    List<ExactPoint> anchors();

    /** The height of a parallel view in scene units; 0 for a camera whose rays meet in one point. */
    default double reach() {
        return 0;
    }

    /**
     * The paper's camera: an eye behind a window. Rays start on the window, so what lies between eye and window is not seen.
     * The window is a parallelogram in any orientation and need not be centred before the eye.
     *
     * @param eye where the viewer is; not in the window's plane
     * @param lowerLeft the window's corner at the picture's lower left
     * @param upperLeft the window's corner at the picture's upper left
     * @param upperRight the window's corner at the picture's upper right: {@code upperLeft + (lowerRight − lowerLeft)}, up to
     *     rounding of the decimals
     * @param lowerRight the window's corner at the picture's lower right
     * @param pupilRadius the radius of the eye's pupil in scene units, at least 0. In physical shading it is a round thin lens in the
     *     eye, parallel to the window, with the window's plane in focus; its radius is at most {@link Lens#MOST_DISTANCES} times the distance
     *     of that plane. Classic shading ignores it
     */
    record Window(
            ExactPoint eye,
            ExactPoint lowerLeft,
            ExactPoint upperLeft,
            ExactPoint upperRight,
            ExactPoint lowerRight,
            double pupilRadius)
            implements Camera {
        /** Validates the components, as {@link Camera} states. */
        public Window {
            checkCorners(lowerLeft, upperLeft, upperRight, lowerRight);
            Check.notNegative("pupilRadius", pupilRadius);
            Vec3 toEye = lowerLeft.directionTo(eye);
            double height = height(toEye, lowerLeft, upperLeft, lowerRight);
            Check.that(height > toEye.length() * 4 * Math.ulp(1.0), "eye", "must not lie in the window's plane");
        }

        private static double height(Vec3 v, ExactPoint lowerLeft, ExactPoint upperLeft, ExactPoint lowerRight) {
            return Math.abs(ExactPoint.normal(lowerLeft, upperLeft, lowerRight)
                    .normalized()
                    .dot(v));
        }

        /** The distance of the window's plane from the eye, in scene units. */
        public double distance() {
            return height(eye.minus(lowerLeft), lowerLeft, upperLeft, lowerRight);
        }

        @Override
        public String type() {
            return "window";
        }

        @Override
        public ExactPoint origin() {
            return eye;
        }

        @Override
        public List<ExactPoint> anchors() {
            return List.of(eye, lowerLeft, upperLeft, upperRight, lowerRight);
        }
    }

    /**
     * A camera whose rays meet in the eye, or pass a lens there.
     *
     * @param eye where the viewer is
     * @param lookAt the point in the middle of the picture; differs from the eye
     * @param up a direction that points upwards in the picture, of any length but 0; not along the line of sight
     * @param fieldOfView the angle of view in degrees, greater than 0 and less than 180
     * @param axis the side of the picture that {@code fieldOfView} spans
     * @param handedness which way the picture's right side points
     * @param lens depth of field, which physical shading alone renders; empty for a pinhole
     */
    record Perspective(
            ExactPoint eye,
            ExactPoint lookAt,
            Vec3 up,
            double fieldOfView,
            FieldOfViewAxis axis,
            Handedness handedness,
            Optional<Lens> lens)
            implements Camera {
        /** Validates the components, as {@link Camera} states. */
        public Perspective {
            checkView(eye, lookAt, up);
            Check.that(
                    fieldOfView > 0 && fieldOfView < 180,
                    "fieldOfView",
                    "must be an angle between 0 and 180 degrees, not " + fieldOfView);
            Objects.requireNonNull(axis, "axis");
            Objects.requireNonNull(handedness, "handedness");
            Objects.requireNonNull(lens, "lens");
        }

        /** A pinhole camera with a vertical angle of view, in left-handed coordinates. */
        public Perspective(ExactPoint eye, ExactPoint lookAt, Vec3 up, double fieldOfView) {
            this(eye, lookAt, up, fieldOfView, FieldOfViewAxis.VERTICAL, Handedness.LEFT, Optional.empty());
        }

        /** This camera with a lens. */
        public Perspective withLens(Lens newLens) {
            return new Perspective(eye, lookAt, up, fieldOfView, axis, handedness, Optional.of(newLens));
        }

        /** This camera with its angle of view along another axis. */
        public Perspective withAxis(FieldOfViewAxis newAxis) {
            return new Perspective(eye, lookAt, up, fieldOfView, newAxis, handedness, lens);
        }

        /** This camera in coordinates of a handedness. */
        public Perspective withHandedness(Handedness newHandedness) {
            return new Perspective(eye, lookAt, up, fieldOfView, axis, newHandedness, lens);
        }

        @Override
        public String type() {
            return "perspective";
        }

        @Override
        public ExactPoint origin() {
            return eye;
        }

        @Override
        public List<ExactPoint> anchors() {
            return around(eye, lens.map(Lens::radius).orElse(0.0));
        }
    }

    /**
     * A camera of parallel rays that start in the plane through the eye.
     *
     * @param eye the middle of the plane that rays start in
     * @param lookAt the point in the middle of the picture; differs from the eye
     * @param up a direction that points upwards in the picture, of any length but 0; not along the line of sight
     * @param height the height of the picture in scene units, greater than 0
     * @param handedness which way the picture's right side points
     */
    record Orthographic(ExactPoint eye, ExactPoint lookAt, Vec3 up, double height, Handedness handedness)
            implements Camera {
        /** Validates the components, as {@link Camera} states. */
        public Orthographic {
            checkView(eye, lookAt, up);
            Check.positive("height", height);
            Objects.requireNonNull(handedness, "handedness");
        }

        /** A view in left-handed coordinates. */
        public Orthographic(ExactPoint eye, ExactPoint lookAt, Vec3 up, double height) {
            this(eye, lookAt, up, height, Handedness.LEFT);
        }

        @Override
        public String type() {
            return "orthographic";
        }

        @Override
        public ExactPoint origin() {
            return eye;
        }

        @Override
        public double reach() {
            return height;
        }

        @Override
        public List<ExactPoint> anchors() {
            return List.of(eye);
        }
    }

    /**
     * The 30° view of technical drawings (the paper's {@code OrthoDraw}): x' = (x − z)·cos 30°, y' = y + (x + z)·sin 30°,
     * seen from above, from the side of negative x and z. Rays start behind the whole scene, so that nothing is cut off.
     *
     * @param lookAt the point in the middle of the picture
     * @param height the height of the picture in scene units, greater than 0
     */
    record Isometric(ExactPoint lookAt, double height) implements Camera {
        /** Validates the components, as {@link Camera} states. */
        public Isometric {
            Objects.requireNonNull(lookAt, "lookAt");
            Check.positive("height", height);
        }

        @Override
        public String type() {
            return "isometric";
        }

        @Override
        public ExactPoint origin() {
            return lookAt;
        }

        @Override
        public double reach() {
            return height;
        }

        @Override
        public List<ExactPoint> anchors() {
            return List.of(lookAt);
        }
    }

    /**
     * All directions, by longitude from left to right and latitude from top to bottom: 360° by 180° (equirectangular). A picture twice as
     * wide as it is high has square pixels in its middle.
     *
     * <p>With an {@code eyeSeparation} the picture is a stereo pair (S. Peleg, M. Ben-Ezra and Y. Pritch, "Omnistereo: panoramic stereo
     * imaging", 2001): the left eye's panorama is its upper half, the right eye's its lower half. Rays of an eye are tangents of a circle
     * around {@code eye}, in the plane perpendicular to the picture's upward axis, so that the eyes stand beside each other for each
     * longitude.
     *
     * @param eye where the viewer is; of a stereo pair the middle between the eyes
     * @param lookAt the point in the middle of the panorama; differs from the eye
     * @param up a direction that points upwards in the picture, of any length but 0; not along the line of sight
     * @param eyeSeparation the distance between the two eyes in scene units, at least 0; 0 is one panorama
     * @param handedness which way the picture's right side points
     */
    record Panorama(ExactPoint eye, ExactPoint lookAt, Vec3 up, double eyeSeparation, Handedness handedness)
            implements Camera {
        /** Validates the components, as {@link Camera} states. */
        public Panorama {
            checkView(eye, lookAt, up);
            Check.notNegative("eyeSeparation", eyeSeparation);
            Objects.requireNonNull(handedness, "handedness");
        }

        /** A panorama of one eye, in left-handed coordinates. */
        public Panorama(ExactPoint eye, ExactPoint lookAt, Vec3 up) {
            this(eye, lookAt, up, 0, Handedness.LEFT);
        }

        @Override
        public String type() {
            return "panorama";
        }

        @Override
        public ExactPoint origin() {
            return eye;
        }

        @Override
        public List<ExactPoint> anchors() {
            return around(eye, eyeSeparation / 2);
        }
    }

    /** The corners of a box around the points within a distance of an eye; the eye alone where that is 0. */
    private static List<ExactPoint> around(ExactPoint eye, double distance) {
        if (distance == 0) {
            return List.of(eye);
        }
        Vec3 reach = new Vec3(distance, distance, distance);
        return List.of(eye.plus(reach.times(-1)), eye.plus(reach));
    }

    /** Checks the window's corners, with keys of their own: the shared check numbers them. */
    private static void checkCorners(
            ExactPoint lowerLeft, ExactPoint upperLeft, ExactPoint upperRight, ExactPoint lowerRight) {
        try {
            Parallelograms.check("", lowerLeft, upperLeft, upperRight, lowerRight);
        } catch (InvalidValueException e) {
            List<String> corners = List.of("lowerLeft", "upperLeft", "upperRight", "lowerRight");
            boolean counted = e.key().matches("/[0-3]");
            throw new InvalidValueException(counted ? corners.get(e.key().charAt(1) - '0') : e.key(), e.problem());
        }
    }

    private static void checkView(ExactPoint eye, ExactPoint lookAt, Vec3 up) {
        Check.direction("up", up);
        Check.that(!eye.equals(lookAt), "lookAt", "must differ from \"eye\"");
        Vec3 forward = eye.directionTo(lookAt).normalized();
        Vec3 across = forward.cross(up.normalized());
        Check.that(across.length() > 4 * Math.ulp(1.0), "up", "must not point along the line of sight");
    }

    /** The side of the picture that a field of view spans; the other side follows from the aspect ratio. */
    enum FieldOfViewAxis {
        /** The picture's height. */
        VERTICAL,

        /** The picture's width. */
        HORIZONTAL,

        /** The shorter of width and height. */
        SMALLER,

        /** The longer of width and height. */
        LARGER;

        /**
         * Whether the field of view spans the width of a picture.
         *
         * @param width of the picture in pixels, at least 1
         * @param height of the picture in pixels, at least 1
         */
        public boolean spansWidth(int width, int height) {
            return switch (this) {
                case VERTICAL -> false;
                case HORIZONTAL -> true;
                case SMALLER -> width < height;
                case LARGER -> width > height;
            };
        }
    }

    /**
     * The orientation of the coordinates that a view was made for: which way the picture's right side points. The other one shows the mirror
     * image of the scene.
     */
    enum Handedness {
        /** The picture's right is up × forward: x to the right, y up and z away from the viewer. */
        LEFT,

        /** The picture's right is forward × up: x to the right, y up and z towards the viewer. */
        RIGHT
    }

    /**
     * A thin lens in the place of the eye, perpendicular to the line of sight: depth of field (M. Potmesil and I. Chakravarty, "A lens and
     * aperture camera model for synthetic image generation", 1981). A pixel is the mean over the lens, so the radius does not change how bright
     * the picture is. Immutable.
     *
     * @param radius of the aperture in scene units, at least 0 and at most 1000 times {@code focusDistance}; 0 is a pinhole
     * @param focusDistance from the eye to the plane in focus, which is perpendicular to the line of sight, in scene units, greater than 0
     * @param blades the number of corners of the aperture, a regular polygon whose corners have the distance {@code radius} from its centre: 3
     *     to 100; 0 is a circle
     * @param rotation the angle in degrees from the picture's right to a corner of the aperture, counterclockwise in the picture
     */
    record Lens(double radius, double focusDistance, int blades, double rotation) {
        /** The largest radius of an aperture, in distances between the lens and the plane in focus: directions stay within range. */
        public static final int MOST_DISTANCES = 1000;

        private static final int LEAST_BLADES = 3;

        /** The largest number of corners of an aperture. */
        public static final int MOST_BLADES = 100;

        /** @throws InvalidValueException with the key of the scene format, for a component out of its range */
        public Lens {
            Check.notNegative("radius", radius);
            Check.positive("focusDistance", focusDistance);
            Check.that(
                    radius / MOST_DISTANCES <= focusDistance,
                    "radius",
                    "must be at most " + MOST_DISTANCES + " times \"focusDistance\", not " + radius);
            Check.that(
                    blades == 0 || blades >= LEAST_BLADES && blades <= MOST_BLADES,
                    "blades",
                    "must be 0, for a circle, or a whole number from " + LEAST_BLADES + " to " + MOST_BLADES + ", not "
                            + blades);
            Check.finite("rotation", rotation);
        }

        /** A round lens. */
        public static Lens round(double radius, double focusDistance) {
            return new Lens(radius, focusDistance, 0, 0);
        }
    }
}
