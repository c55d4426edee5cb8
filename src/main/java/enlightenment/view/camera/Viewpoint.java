package enlightenment.view.camera;

import enlightenment.camera.Camera;
import enlightenment.math.ExactPoint;
import enlightenment.math.InvalidValueException;
import enlightenment.math.Vec3;
import java.util.Optional;

/**
 * A camera with the point and the pole that it moves around. Immutable; every motion returns another viewpoint.
 *
 * <p>Coordinates that a motion changes are rounded to {@link Digits#KEPT} digits below the camera's distance from its aim, so that the
 * rendered camera is exactly the written one, and files stay readable.
 *
 * @param camera the camera at this viewpoint
 * @param aim the centre of orbits and dollies; {@code lookAt} of cameras that have one
 * @param pole the axis of orbits, of any length but 0; the upward direction of cameras that have one
 */
public record Viewpoint(Camera camera, ExactPoint aim, Vec3 pole) {
    private static final double RIGHT_ANGLE = 90;

    /** The least angle between an orbit and the pole, in degrees: at the pole the upward direction is undefined. */
    private static final double POLE_MARGIN = 1;

    private static final double LEAST_FIELD_OF_VIEW = 0.1;
    private static final double MOST_FIELD_OF_VIEW = 170;

    /** The cosine of 30°, half of which a unit along x or z measures across an isometric picture. */
    private static final double ISOMETRIC = Math.sqrt(3) / 2;

    /** The viewpoint of a scene's camera. A window is aimed at its own middle, until {@link #aimedAt} sets another aim. */
    public static Viewpoint of(Camera camera) {
        if (camera instanceof Camera.Perspective c) {
            return new Viewpoint(c, c.lookAt(), c.up());
        }
        if (camera instanceof Camera.Orthographic c) {
            return new Viewpoint(c, c.lookAt(), c.up());
        }
        if (camera instanceof Camera.Panorama c) {
            return new Viewpoint(c, c.lookAt(), c.up());
        }
        if (camera instanceof Camera.Isometric c) {
            return new Viewpoint(c, c.lookAt(), Vec3.Y);
        }
        Camera.Window c = (Camera.Window) camera;
        Vec3 diagonal = c.upperRight().minus(c.lowerLeft());
        return new Viewpoint(
                c, c.lowerLeft().plus(diagonal.times(0.5)), Pose.of(c).up());
    }

    private Viewpoint with(Camera moved) {
        return new Viewpoint(moved, aim, pole);
    }

    /** The distance between eye and aim, in scene units; 0 of an isometric view. */
    public double distance() {
        return camera instanceof Camera.Isometric
                ? 0
                : camera.origin().minus(aim).length();
    }

    /**
     * Moves the camera around its aim, which keeps its distance and its place in the picture.
     *
     * @param right degrees around the pole, towards the picture's right
     * @param up degrees towards the pole, clamped before it
     * @throws InvalidValueException for a camera that cannot turn
     */
    public Viewpoint orbit(double right, double up) {
        requireTurning();
        Vec3 axis = pole.normalized();
        Vec3 from = camera.origin().minus(aim);
        double sense = Math.signum(Pose.of(camera).right().dot(axis.cross(from)));
        Vec3 turned = Rotations.turned(from, axis, sense * right);
        double elevation = RIGHT_ANGLE - Rotations.between(turned, axis);
        double limit = RIGHT_ANGLE - POLE_MARGIN;
        double most = Math.max(limit, elevation);
        double least = Math.min(-limit, elevation);
        double rise = Math.min(Math.max(elevation + up, least), most) - elevation;
        Vec3 tilt = turned.cross(axis).normalized();
        return with(CameraPoints.moved(
                camera,
                p -> aim.plus(Rotations.turned(Rotations.turned(p.minus(aim), axis, sense * right), tilt, rise)),
                aim,
                pole));
    }

    /**
     * Moves camera and aim sideways, so that points at the aim's distance follow a pointer.
     *
     * @param x motion of the pointer to the right, in heights of the picture
     * @param y motion of the pointer downwards, in heights of the picture
     * @param aspect width of the picture over its height
     */
    public Viewpoint pan(double x, double y, double aspect) {
        if (camera instanceof Camera.Isometric c) {
            double across = -x * c.height() / (2 * ISOMETRIC);
            ExactPoint to = Digits.rounded(c.lookAt().plus(new Vec3(across, y * c.height(), -across)), c.height());
            return new Viewpoint(new Camera.Isometric(to, c.height()), to, pole);
        }
        double height = heightAtAim(aspect);
        Vec3 step = Pose.of(camera).direction(-x * height, y * height, 0);
        ExactPoint newAim = Digits.rounded(aim.plus(step), distance());
        Camera moved = CameraPoints.moved(camera, p -> p.plus(step), newAim, pole);
        return new Viewpoint(moved, newAim, pole);
    }

    /** The height of the field of view at the aim's distance, in scene units. */
    private double heightAtAim(double aspect) {
        if (camera instanceof Camera.Orthographic c) {
            return c.height();
        }
        if (camera instanceof Camera.Perspective c) {
            double half = StrictMath.tan(StrictMath.toRadians(c.fieldOfView() / 2));
            boolean isWide = aspect > 1;
            boolean spansWidth =
                    switch (c.axis()) {
                        case VERTICAL -> false;
                        case HORIZONTAL -> true;
                        case SMALLER -> !isWide;
                        case LARGER -> isWide;
                    };
            return 2 * distance() * (spansWidth ? half / aspect : half);
        }
        if (camera instanceof Camera.Window c) {
            double height = c.upperLeft().minus(c.lowerLeft()).length();
            return height * Math.abs(Pose.of(c).depth(aim)) / c.distance();
        }
        // A panorama shows half a turn over its height.
        return distance() * Math.PI;
    }

    /**
     * Scales the distance from the camera to its aim; for a parallel view the picture's height.
     *
     * @param factor new distance over the old one, greater than 0
     */
    public Viewpoint dolly(double factor) {
        if (camera instanceof Camera.Isometric c) {
            return with(new Camera.Isometric(c.lookAt(), Digits.rounded(c.height() * factor)));
        }
        if (camera instanceof Camera.Orthographic c) {
            double height = Digits.rounded(c.height() * factor);
            return with(new Camera.Orthographic(c.eye(), c.lookAt(), c.up(), height, c.handedness()));
        }
        Vec3 step = camera.origin().minus(aim).times(factor - 1);
        return with(CameraPoints.moved(camera, p -> p.plus(step), aim, pole));
    }

    /**
     * Turns the camera around its line of sight.
     *
     * @param degrees clockwise rotation of the picture
     * @throws InvalidValueException for a camera that cannot turn
     */
    public Viewpoint roll(double degrees) {
        requireTurning();
        Pose pose = Pose.of(camera);
        double angle = StrictMath.toRadians(degrees);
        double cos = StrictMath.cos(angle);
        double sin = StrictMath.sin(angle);
        Vec3 up = Digits.direction(pose.direction(-sin, cos, 0));
        if (camera instanceof Camera.Window c) {
            ExactPoint eye = c.eye();
            Camera rolled = CameraPoints.moved(
                    c,
                    p -> {
                        Vec3 d = p.minus(eye);
                        double r = d.dot(pose.right());
                        double u = d.dot(pose.up());
                        return eye.plus(pose.direction(r * cos - u * sin, r * sin + u * cos, d.dot(pose.forward())));
                    },
                    aim,
                    up);
            return new Viewpoint(rolled, aim, up);
        }
        return new Viewpoint(CameraPoints.with(camera, camera.origin(), aim, up), aim, up);
    }

    /**
     * Sets the field of view.
     *
     * @param degrees field of view, clamped to 0.1..170
     * @throws InvalidValueException unless the camera is a perspective one
     */
    public Viewpoint withFieldOfView(double degrees) {
        if (!(camera instanceof Camera.Perspective c)) {
            throw new InvalidValueException("fieldOfView", "is no part of a camera of type " + camera.type());
        }
        double angle = Digits.rounded(Math.min(Math.max(degrees, LEAST_FIELD_OF_VIEW), MOST_FIELD_OF_VIEW));
        return with(new Camera.Perspective(c.eye(), c.lookAt(), c.up(), angle, c.axis(), c.handedness(), c.lens()));
    }

    /**
     * Moves the aim along the line of sight to the depth of a point. The aim of a window becomes the point itself.
     *
     * @throws InvalidValueException if the point does not lie in front of the eye, or the view is isometric
     */
    public Viewpoint aimedAt(ExactPoint point) {
        requireTurning();
        double depth = depthOf(point);
        if (camera instanceof Camera.Window) {
            return new Viewpoint(camera, point, pole);
        }
        ExactPoint to =
                Digits.rounded(camera.origin().plus(Pose.of(camera).forward().times(depth)), depth);
        return new Viewpoint(CameraPoints.with(camera, camera.origin(), to, pole), to, pole);
    }

    /**
     * Focuses the lens on the plane through a point.
     *
     * @throws InvalidValueException if the camera has no lens, or the point does not lie in front of it
     */
    public Viewpoint focusedOn(ExactPoint point) {
        if (!(camera instanceof Camera.Perspective c) || c.lens().isEmpty()) {
            throw new InvalidValueException("lens", "is missing: this camera has nothing to focus");
        }
        Camera.Lens lens = c.lens().get();
        double distance = Digits.rounded(depthOf(point));
        Camera.Lens focused = new Camera.Lens(lens.radius(), distance, lens.blades(), lens.rotation());
        return with(new Camera.Perspective(
                c.eye(), c.lookAt(), c.up(), c.fieldOfView(), c.axis(), c.handedness(), Optional.of(focused)));
    }

    private double depthOf(ExactPoint point) {
        double depth = Pose.of(camera).depth(point);
        if (!(depth > 0)) {
            throw new InvalidValueException("lookAt", "must lie in front of the camera");
        }
        return depth;
    }

    private void requireTurning() {
        if (camera instanceof Camera.Isometric) {
            throw new InvalidValueException(
                    "camera", "is isometric: its direction is fixed; it can be panned and zoomed");
        }
    }
}
