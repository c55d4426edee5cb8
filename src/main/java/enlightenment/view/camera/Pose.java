package enlightenment.view.camera;

import enlightenment.camera.Camera;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;

/**
 * Position and orientation of a camera: its eye, and the unit axes of its picture.
 *
 * @param eye centre of projection, in scene units
 * @param right unit vector towards the picture's right side
 * @param up unit vector towards the picture's upper side
 * @param forward unit vector along the line of sight; for a window camera the normal of the window
 */
public record Pose(ExactPoint eye, Vec3 right, Vec3 up, Vec3 forward) {

    /** The pose of any camera but an isometric one, which has no eye. */
    public static Pose of(Camera camera) {
        if (camera instanceof Camera.Perspective c) {
            return of(c.eye(), c.lookAt(), c.up(), c.handedness());
        }
        if (camera instanceof Camera.Orthographic c) {
            return of(c.eye(), c.lookAt(), c.up(), c.handedness());
        }
        if (camera instanceof Camera.Panorama c) {
            return of(c.eye(), c.lookAt(), c.up(), c.handedness());
        }
        if (camera instanceof Camera.Window c) {
            Vec3 right = c.lowerLeft().directionTo(c.lowerRight()).normalized();
            Vec3 side = c.lowerLeft().directionTo(c.upperLeft());
            Vec3 up = side.minus(right.times(side.dot(right))).normalized();
            Vec3 normal = right.cross(up);
            boolean isAhead = normal.dot(c.eye().directionTo(c.lowerLeft())) > 0;
            return new Pose(c.eye(), right, up, isAhead ? normal : normal.negated());
        }
        throw new IllegalArgumentException("a camera of type " + camera.type() + " has no pose");
    }

    private static Pose of(ExactPoint eye, ExactPoint lookAt, Vec3 upwards, Camera.Handedness handedness) {
        Vec3 forward = eye.directionTo(lookAt).normalized();
        Vec3 pole = upwards.normalized();
        Vec3 across = handedness == Camera.Handedness.LEFT ? pole.cross(forward) : forward.cross(pole);
        Vec3 right = across.normalized();
        Vec3 up = handedness == Camera.Handedness.LEFT ? forward.cross(right) : right.cross(forward);
        return new Pose(eye, right, up, forward);
    }

    /** The direction with the given components along right, up and forward. */
    public Vec3 direction(double r, double u, double f) {
        return right.times(r).plus(up.times(u)).plus(forward.times(f));
    }

    /** The distance of a point from the eye along the line of sight, in scene units; negative behind the eye. */
    public double depth(ExactPoint point) {
        return point.minus(eye).dot(forward);
    }
}
