package enlightenment.camera;

import enlightenment.check.Check;
import enlightenment.frame.Parallelograms;
import enlightenment.math.ExactPoint;
import enlightenment.math.InvalidValueException;
import enlightenment.math.Vec3;
import java.util.List;

/** Where the picture is seen from. */
public sealed interface Camera permits Camera.Window, Camera.Perspective, Camera.Orthographic, Camera.Isometric {

    /** The name of this kind of camera in the scene format. */
    String type();

    /** The point that becomes the origin of the frame that the scene is rendered in. */
    ExactPoint origin();

    /** Points that belong to the camera. */
    List<ExactPoint> anchors();

    /** The height of a view of parallel rays; 0 where rays meet in one point. */
    default double reach() {
        return 0;
    }

    /**
     * The paper's camera: an eye behind a window. Rays start on the window, so what stands between eye and window is not
     * seen. The window may have any orientation and need not stand straight before the eye.
     *
     * @param eye where the viewer is; not in the window's plane
     * @param lowerLeft the window's corner at the picture's lower left
     * @param upperLeft next corner
     * @param upperRight next corner
     * @param lowerRight last corner
     * @param pupilRadius the eye's size; only light tracing looks at it
     */
    record Window(
            ExactPoint eye,
            ExactPoint lowerLeft,
            ExactPoint upperLeft,
            ExactPoint upperRight,
            ExactPoint lowerRight,
            double pupilRadius)
            implements Camera {
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
     * @param lookAt what is seen in the middle of the picture; differs from the eye
     * @param up what points upwards in the picture; not along the line of sight
     * @param fieldOfView the vertical angle of view in degrees, greater than 0 and less than 180
     */
    record Perspective(ExactPoint eye, ExactPoint lookAt, Vec3 up, double fieldOfView) implements Camera {
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
     * @param eye the middle of the picture's plane
     * @param lookAt what is seen in the middle of the picture; differs from the eye
     * @param up what points upwards in the picture; not along the line of sight
     * @param height the height of the picture in scene units, greater than 0
     */
    record Orthographic(ExactPoint eye, ExactPoint lookAt, Vec3 up, double height) implements Camera {
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
     * seen from above, from the side of negative x and z. Everything is seen, however far.
     *
     * @param lookAt what is seen in the middle of the picture
     * @param height the height of the picture in scene units, greater than 0
     */
    record Isometric(ExactPoint lookAt, double height) implements Camera {
        public Isometric {
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

    /** The check of four corners counts them; here they have names. */
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
