package enlightenment.world.camera;

import enlightenment.camera.Camera;
import enlightenment.math.Vec3;

/** Orthonormal axes of a view: in the paper's axes, right is +x and up is +y for a viewer who looks along +z. */
final class View {
    final Vec3 forward;
    final Vec3 right;
    final Vec3 up;

    View(Vec3 along, Vec3 upwards, Camera.Handedness handedness) {
        forward = along.normalized();
        Vec3 leftHanded = upwards.normalized().cross(forward).normalized();
        up = forward.cross(leftHanded);
        right = handedness == Camera.Handedness.LEFT ? leftHanded : leftHanded.times(-1);
    }
}
