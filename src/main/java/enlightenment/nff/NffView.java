package enlightenment.nff;

import enlightenment.camera.Camera;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import java.math.BigDecimal;

/**
 * A {@code v} entity.
 *
 * @param from the eye
 * @param at what is seen in the middle
 * @param up what points upwards
 * @param angle between the centres of the top and the bottom row of pixels, and of the left and the right column, degrees
 * @param hither distance of the plane before which nothing is seen; not positive where there is none
 * @param width pixels across
 * @param height pixels down
 */
record NffView(ExactPoint from, ExactPoint at, Vec3 up, double angle, double hither, int width, int height) {

    /**
     * The window through which the view looks. It stands at the hither plane, because what is before a window is not seen
     * either; its corners say outright what is left and right, so a right-handed file needs no other coordinates.
     */
    Camera.Window window() {
        Vec3 forward = at.minus(from).normalized();
        Vec3 right = forward.cross(up.normalized()).normalized();
        Vec3 top = right.cross(forward);
        double distance = distance();
        double halfHeight = distance * halfHeightAtUnitDistance();
        Vec3 middle = forward.times(distance);
        Vec3 across = right.times(halfHeight * width / height);
        Vec3 upwards = top.times(halfHeight);
        return new Camera.Window(
                from,
                corner(middle.minus(across).minus(upwards)),
                corner(middle.minus(across).plus(upwards)),
                corner(middle.plus(across).plus(upwards)),
                corner(middle.plus(across).minus(upwards)),
                0);
    }

    /** The angle ends at the centres of the outer pixels, a window at their outer edges. */
    private double halfHeightAtUnitDistance() {
        double toCentres = StrictMath.tan(StrictMath.toRadians(angle / 2));
        return height == 1 ? toCentres : toCentres * height / (height - 1);
    }

    /** Without a hither plane the window stands so near to the eye that nothing has room before it. */
    private double distance() {
        return hither > 0 ? hither : at.minus(from).scaledBy(-40).length();
    }

    /** Shortest decimals of the offset, added exactly to the eye: as precise far from the origin as near it. */
    private ExactPoint corner(Vec3 offset) {
        return new ExactPoint(
                from.x().add(BigDecimal.valueOf(offset.x())),
                from.y().add(BigDecimal.valueOf(offset.y())),
                from.z().add(BigDecimal.valueOf(offset.z())));
    }
}
