package enlightenment.importer.support;

import enlightenment.camera.Camera;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import java.math.BigDecimal;

/**
 * Where a foreign camera stands and looks. Which way the picture's right points says whether its coordinates are right- or left-handed; mirrored
 * cameras come out right, too. A value.
 *
 * @param eye where the viewer is
 * @param forward along the view, of any length but 0
 * @param up upwards in the picture; what of it lies along the view does not matter
 * @param right to the right in the picture; only its side counts
 */
public record ImportView(Vec3 eye, Vec3 forward, Vec3 up, Vec3 right) {
    /** A pinhole's window is so near, relative to the eye's distance from the target, that nothing has room before it. */
    private static final int NEAR = -40;

    /**
     * The view of a camera whose coordinates are mapped to those of the scene.
     *
     * @param toScene the map
     * @param forward along the view, in the camera's coordinates
     * @param up upwards in the picture, there
     * @param right to the right in the picture, there
     */
    public static ImportView of(Affine toScene, Vec3 forward, Vec3 up, Vec3 right) {
        return new ImportView(toScene.offset(), toScene.vector(forward), toScene.vector(up), toScene.vector(right));
    }

    /**
     * A pinhole camera.
     *
     * @param verticalDegrees the vertical angle of view
     */
    public Camera.Perspective pinhole(double verticalDegrees) {
        return new Camera.Perspective(Affine.exact(eye), Affine.exact(lookAt()), up, verticalDegrees)
                .withHandedness(handedness());
    }

    /** The point in the middle of the picture. */
    public Vec3 lookAt() {
        return eye.plus(forward);
    }

    private Camera.Handedness handedness() {
        return forward.cross(up).dot(right) < 0 ? Camera.Handedness.LEFT : Camera.Handedness.RIGHT;
    }

    /**
     * A pinhole camera whose picture need not lie around the direction of view: each side is the tangent of its angle from there, negative to the left
     * and downwards.
     */
    public Camera window(double left, double right, double bottom, double top) {
        Vec3 f = forward.normalized();
        Vec3 across = f.cross(up).normalized();
        Vec3 toRight = across.dot(this.right) < 0 ? across.times(-1) : across;
        Vec3 toTop = across.cross(f);
        double distance = forward.scaledBy(NEAR).length();
        Vec3 middle = f.times(distance);
        Vec3 l = middle.plus(toRight.times(left * distance));
        Vec3 r = middle.plus(toRight.times(right * distance));
        Vec3 b = toTop.times(bottom * distance);
        Vec3 t = toTop.times(top * distance);
        return new Camera.Window(
                Affine.exact(eye), corner(l.plus(b)), corner(l.plus(t)), corner(r.plus(t)), corner(r.plus(b)), 0);
    }

    /**
     * A camera of parallel rays that start in the plane through the eye.
     *
     * @param height of the picture, in units of the scene
     */
    public Camera parallel(double height) {
        return new Camera.Orthographic(Affine.exact(eye), Affine.exact(lookAt()), up, height, handedness());
    }

    /** A camera of all directions, by longitude and latitude; the view is in the middle of its picture. */
    public Camera.Panorama panorama() {
        return new Camera.Panorama(Affine.exact(eye), Affine.exact(lookAt()), up, 0, handedness());
    }

    private ExactPoint corner(Vec3 offset) {
        ExactPoint e = Affine.exact(eye);
        return new ExactPoint(
                e.x().add(BigDecimal.valueOf(offset.x())),
                e.y().add(BigDecimal.valueOf(offset.y())),
                e.z().add(BigDecimal.valueOf(offset.z())));
    }
}
