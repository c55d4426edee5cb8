package enlightenment.world.camera;

import enlightenment.math.Vec3;

/**
 * A thin lens around the point that an affine camera's rays meet in, parallel to the plane in focus. The ray of a point l of the lens is
 * the middle ray, g, with its origin moved by l·a and its direction changed by l·b, so that both meet in the plane in focus. As a and b are
 * parallel to this plane, each point of the lens is the eye of an affine camera with the same determinant. Immutable.
 */
final class ThinLens {
    /** The numbers of its four vectors. */
    private static final int VECTORS = 12;

    private final Aperture aperture;

    /** The radius of the lens towards the picture's right and upwards, as vectors of the frame. */
    private final Vec3 right;

    private final Vec3 up;

    /** Both radii over the distance of the plane in focus, measured in lengths of the ray's direction. */
    private final Vec3 turnRight;

    private final Vec3 turnUp;

    /**
     * @param right the radius to one side, in the frame
     * @param up the radius across it
     * @param turnRight {@code right} over the t of the middle ray at the plane in focus
     * @param turnUp {@code up} over that t
     */
    ThinLens(Aperture aperture, Vec3 right, Vec3 up, Vec3 turnRight, Vec3 turnUp) {
        this.aperture = aperture;
        this.right = right;
        this.up = up;
        this.turnRight = turnRight;
        this.turnUp = turnUp;
    }

    /** Maps the unit square to a point of the aperture in the unit circle, with three numbers, as the other methods take it. */
    double[] sample(double u, double v) {
        double[] point = new double[3];
        aperture.sample(u, v, point);
        return point;
    }

    /** The point of the lens, relative to its middle. */
    Vec3 start(double[] point) {
        return right.times(point[0]).plus(up.times(point[1]));
    }

    /** The vector to subtract from the direction of the middle ray. */
    Vec3 turn(double[] point) {
        return turnRight.times(point[0]).plus(turnUp.times(point[1]));
    }

    Vec3 right() {
        return right;
    }

    Vec3 up() {
        return up;
    }

    /** As {@link CompiledCamera#lensForm}. */
    double[] flatForm() {
        double[] corners = aperture.corners();
        double[] all = new double[VECTORS + corners.length];
        Vec3[] vectors = {right, up, turnRight, turnUp};
        for (int k = 0; k < VECTORS; k++) {
            all[k] = vectors[k / 3].component(k % 3);
        }
        System.arraycopy(corners, 0, all, VECTORS, corners.length);
        return all;
    }
}
