package enlightenment.view.camera;

import enlightenment.camera.Camera;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import java.util.function.UnaryOperator;

/** Copies of cameras with other points; not for isometric views, which have no eye. */
public final class CameraPoints {
    private CameraPoints() {}

    /**
     * A copy of a camera whose points are moved and rounded.
     *
     * @param move the motion of eye and window corners
     * @param aim the new look-at point
     * @param up the new upward direction; unused for a window, which has none
     */
    public static Camera moved(Camera camera, UnaryOperator<ExactPoint> move, ExactPoint aim, Vec3 up) {
        ExactPoint exact = move.apply(camera.origin());
        double distance = exact.minus(aim).length();
        ExactPoint eye = Digits.rounded(exact, distance);
        if (!(camera instanceof Camera.Window c)) {
            return with(camera, eye, aim, up);
        }
        // The window may be far nearer than the aim.
        double size = Math.min(distance, c.lowerLeft().minus(c.upperRight()).length());
        ExactPoint lowerLeft = Digits.rounded(move.apply(c.lowerLeft()), size);
        ExactPoint upperLeft = Digits.rounded(move.apply(c.upperLeft()), size);
        ExactPoint lowerRight = Digits.rounded(move.apply(c.lowerRight()), size);
        ExactPoint upperRight = new ExactPoint(
                upperLeft.x().add(lowerRight.x()).subtract(lowerLeft.x()),
                upperLeft.y().add(lowerRight.y()).subtract(lowerLeft.y()),
                upperLeft.z().add(lowerRight.z()).subtract(lowerLeft.z()));
        return new Camera.Window(
                Digits.rounded(exact, size), lowerLeft, upperLeft, upperRight, lowerRight, c.pupilRadius());
    }

    /** A copy of a camera, not a window, with other points and another upward direction. */
    public static Camera with(Camera camera, ExactPoint eye, ExactPoint lookAt, Vec3 up) {
        if (camera instanceof Camera.Perspective c) {
            return new Camera.Perspective(eye, lookAt, up, c.fieldOfView(), c.axis(), c.handedness(), c.lens());
        }
        if (camera instanceof Camera.Orthographic c) {
            return new Camera.Orthographic(eye, lookAt, up, c.height(), c.handedness());
        }
        Camera.Panorama c = (Camera.Panorama) camera;
        return new Camera.Panorama(eye, lookAt, up, c.eyeSeparation(), c.handedness());
    }
}
