package enlightenment.camera;

import enlightenment.check.Check;
import enlightenment.frame.Parallelograms;
import enlightenment.math.ExactPoint;
import enlightenment.math.InvalidValueException;
import enlightenment.math.Vec3;
import java.util.List;
import java.util.Objects;

/**
 * Where the picture is seen from: an immutable description in scene coordinates and scene units, exact, validated when it is
 * made.
 *
 * <p>The constructors throw {@link InvalidValueException}, with the key of the scene format, for a value out of range or a
 * degenerate view, and {@link NullPointerException} for a missing value. Angles are degrees.
 */
public sealed interface Camera permits Camera.Window, Camera.Perspective, Camera.Orthographic, Camera.Isometric {

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
     * @param pupilRadius the radius of the eye's pupil, at least 0. Above 0 it stands for the original's, which was to catch rays
     *     from the lamp that pass near the eye: classic shading has no such rays, and physical shading refuses it
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
            Vec3 normal = ExactPoint.normal(lowerLeft, upperLeft, lowerRight).normalized();
            Vec3 toEye = lowerLeft.directionTo(eye);
            double height = Math.abs(normal.dot(toEye));
            Check.that(height > toEye.length() * 4 * Math.ulp(1.0), "eye", "must not lie in the window's plane");
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
     * A pinhole camera.
     *
     * @param eye where the viewer is
     * @param lookAt the point in the middle of the picture; differs from the eye
     * @param up a direction that points upwards in the picture, of any length but 0; not along the line of sight
     * @param fieldOfView the vertical angle of view in degrees, greater than 0 and less than 180
     */
    record Perspective(ExactPoint eye, ExactPoint lookAt, Vec3 up, double fieldOfView) implements Camera {
        /** Validates the components, as {@link Camera} states. */
        public Perspective {
            checkView(eye, lookAt, up);
            Check.that(
                    fieldOfView > 0 && fieldOfView < 180,
                    "fieldOfView",
                    "must be an angle between 0 and 180 degrees, not " + fieldOfView);
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
            return List.of(eye);
        }
    }

    /**
     * A camera of parallel rays that start in the plane through the eye.
     *
     * @param eye the middle of the plane that rays start in
     * @param lookAt the point in the middle of the picture; differs from the eye
     * @param up a direction that points upwards in the picture, of any length but 0; not along the line of sight
     * @param height the height of the picture in scene units, greater than 0
     */
    record Orthographic(ExactPoint eye, ExactPoint lookAt, Vec3 up, double height) implements Camera {
        /** Validates the components, as {@link Camera} states. */
        public Orthographic {
            checkView(eye, lookAt, up);
            Check.positive("height", height);
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
}
