package enlightenment.world.camera;

import enlightenment.math.Vec3;

/**
 * A thin lens around the point that an affine camera's rays meet in, parallel to the plane in focus. The ray of a point of the lens is that
 * of the middle, g, moved to the point l·a and turned by l·b, so that both meet in the plane in focus. As a and b are parallel to this
 * plane, each point of the lens is the eye of an affine camera with the same determinant. Immutable.
 */
final class ThinLens {
    private final Aperture aperture;

    /** The circle's radius towards the picture's right and upwards, in the frame. */
    private final Vec3 right;

    private final Vec3 up;

    /** Both radii over the distance of the plane in focus, in lengths of directions. */
    private final Vec3 turnRight;

    private final Vec3 turnUp;

    /**
     * @param right the radius to one side, in the frame
     * @param up the radius across it
     * @param turnRight {@code right} over where on the middle ray the plane in focus is
     * @param turnUp {@code up} over that
     */
    ThinLens(Aperture aperture, Vec3 right, Vec3 up, Vec3 turnRight, Vec3 turnUp) {
        this.aperture = aperture;
        this.right = right;
        this.up = up;
        this.turnRight = turnRight;
        this.turnUp = turnUp;
    }

    /** Maps the unit square to a point of the unit disk, with three numbers, which the other methods take. */
    double[] sample(double u, double v) {
        double[] point = new double[3];
        aperture.sample(u, v, point);
        return point;
    }

    /** The point of the lens. */
    Vec3 start(double[] point) {
        return right.times(point[0]).plus(up.times(point[1]));
    }

    /** What is subtracted from the direction of the middle ray. */
    Vec3 turn(double[] point) {
        return turnRight.times(point[0]).plus(turnUp.times(point[1]));
    }

    Vec3 right() {
        return right;
    }

    Vec3 up() {
        return up;
    }
}
