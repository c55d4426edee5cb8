package enlightenment.transport.image;

import enlightenment.frame.Basis;
import enlightenment.primitive.SpherePrimitive;
import enlightenment.world.light.PhysicalLight;

/**
 * The image of a ball in a mirror that is a sphere, as seen from a point outside of the mirror: a sector of directions around the axis from
 * the point to the mirror's centre, which holds all directions that the mirror reflects into the ball.
 *
 * <p>Everything but the ball is symmetric around the axis. So in the plane of point, mirror's centre and ball's centre two problems of one
 * unknown, where a reflected line touches the ball, give the least and the greatest angle to the axis (J. Alhazen's problem, by Newton's
 * method); and a line that meets the ball is turned out of that plane by an angle whose sine is at most the ball's radius over its centre's
 * distance from the axis. Lengths are in radii of the mirror there, coordinates are along the axis, from the mirror's centre, and across.
 *
 * <p>The sector is a function of its arguments alone. A sector that rounding makes too small changes variance only: {@link #contains}
 * decides which directions belong to it. A mutable work object, one per thread.
 */
final class MirrorImage {
    /** The number of Newton steps to the reflection of the ball's centre, and from there to either edge. */
    private static final int STEPS_TO_CENTER = 5;

    private static final int STEPS_TO_EDGE = 4;

    /** The share by which the sector is widened to either side, for the error that Newton's steps leave. */
    private static final double MARGIN = 0x1p-6;

    /** The error of a Newton step, in radii of the ball, below which the next step's error is negligible. */
    private static final double NEAR = 0x1p-3;

    private final Basis basis = new Basis();

    /** The density per solid angle of {@link #sample}, uniform over the sector; 0 if there is no image. */
    double pdf;

    /** The sampled direction, a unit vector in the frame. */
    double dx;

    double dy;
    double dz;

    /** Unit vectors: from the point to the mirror's centre; across that towards the ball; across both. */
    private double ax;

    private double ay;
    private double az;
    private double ux;
    private double uy;
    private double uz;
    private double vx;
    private double vy;
    private double vz;

    /** The least and the greatest 1 − cosine of the angle to the axis. */
    private double least;

    private double greatest;

    /** The largest angle around the axis, from the plane of the three points, and its cosine. */
    private double turn;

    private double turnCosine;

    /** The point's distance from the mirror's centre; the ball's centre; the ball's radius. */
    private double eye;

    private double bx;
    private double by;
    private double radius;

    /** The current point of the mirror, in the plane. */
    private double nx;

    private double ny;

    /** The signed distance of the ball's centre from the line reflected at that point, and its derivative as the point turns. */
    private double miss;

    private double slope;

    /** The distance along the reflected line to its point nearest to the ball's centre. */
    private double on;

    /** Finds the image of the bounding ball of a light. See the other {@code aim}. */
    boolean aim(SpherePrimitive mirror, PhysicalLight l, double x, double y, double z) {
        return aim(
                mirror.x(), mirror.y(), mirror.z(), mirror.radius(), l.ballX, l.ballY, l.ballZ, l.ballRadius, x, y, z);
    }

    /**
     * Finds the image; there is none from inside the mirror, nor if the ball's centre is in it. Coordinates are in the frame.
     *
     * @param cx the mirror's centre, with cy and cz
     * @param size the mirror's radius
     * @param qx the ball's centre, with qy and qz
     * @param r the ball's radius
     * @param x the point, with y and z
     * @return whether there is one
     */
    boolean aim(
            double cx,
            double cy,
            double cz,
            double size,
            double qx,
            double qy,
            double qz,
            double r,
            double x,
            double y,
            double z) {
        pdf = 0;
        double ex = (x - cx) / size;
        double ey = (y - cy) / size;
        double ez = (z - cz) / size;
        eye = Math.sqrt(ex * ex + ey * ey + ez * ez);
        if (!(eye > 1)) {
            return false;
        }
        radius = r / size;
        ax = -ex / eye;
        ay = -ey / eye;
        az = -ez / eye;
        across((qx - cx) / size, (qy - cy) / size, (qz - cz) / size);
        return bx * bx + by * by > 1 && findAngles();
    }

    /** Sets the directions across the axis, and the ball's centre. */
    private void across(double x, double y, double z) {
        double along = x * ax + y * ay + z * az;
        bx = -along;
        double px = Math.fma(-along, ax, x);
        double py = Math.fma(-along, ay, y);
        double pz = Math.fma(-along, az, z);
        by = Math.sqrt(px * px + py * py + pz * pz);
        if (by > 0) {
            ux = px / by;
            uy = py / by;
            uz = pz / by;
        } else {
            basis.around(ax, ay, az);
            ux = basis.ax;
            uy = basis.ay;
            uz = basis.az;
        }
        vx = ay * uz - az * uy;
        vy = az * ux - ax * uz;
        vz = ax * uy - ay * ux;
    }

    private boolean findAngles() {
        toLimb();
        reflect();
        double limb = height();
        // For a ball before the limb, the line that touches the mirror gives no bound.
        double missOfLimb = on > 0 ? miss : Double.NEGATIVE_INFINITY;
        if (!(missOfLimb < radius)) {
            return false;
        }
        if (missOfLimb < 0) {
            toCenter();
        }
        double centerX = nx;
        double centerY = ny;
        greatest = missOfLimb < -radius && toEdge(-radius) ? height() : limb;
        least = 0;
        turn = Math.PI;
        turnCosine = -1;
        if (by > radius) {
            nx = centerX;
            ny = centerY;
            least = toEdge(radius) ? height() : 0;
            turn = StrictMath.asin(radius / by);
            turnCosine = Math.sqrt((1 - radius / by) * (1 + radius / by));
        }
        double margin = MARGIN * (greatest - least);
        least = Math.max(least - margin, 0);
        greatest = Math.min(greatest + margin, limb);
        double density = 1 / (2 * turn * (greatest - least));
        pdf = density > 0 && density <= Double.MAX_VALUE ? density : 0;
        return pdf > 0;
    }

    /** Moves to where the line from the point touches the mirror. */
    private void toLimb() {
        nx = 1 / eye;
        ny = Math.sqrt((1 - nx) * (1 + nx));
    }

    /**
     * Moves to where the law of reflection holds for the ball's centre, if Newton's method finds that; near it in most cases. It begins in
     * the middle of what is seen both from the point and from the ball's centre.
     */
    private void toCenter() {
        double far = Math.sqrt(bx * bx + by * by);
        double ballX = bx / far;
        double ballY = by / far;
        double sine = Math.sqrt((1 - 1 / far) * (1 + 1 / far));
        double startX = ballX / far + ballY * sine;
        double startY = ballY / far - ballX * sine;
        if (startY < 0) {
            startX = 1;
            startY = 0;
        }
        toLimb();
        boolean isBallBefore = ballX > nx;
        turnTo(startX + (isBallBefore ? ballX : nx), startY + (isBallBefore ? ballY : ny));
        for (int k = 0; k < STEPS_TO_CENTER; k++) {
            double eyeAcross = eye * ny;
            double eyeAlong = eye * nx;
            double ballAlong = bx * nx + by * ny;
            double ballAcross = by * nx - bx * ny;
            double f = eyeAcross * (ballAlong - 1) - ballAcross * (eyeAlong - 1);
            double change = eyeAlong * (ballAlong - 1) + ballAlong * (eyeAlong - 1) + 2 * eyeAcross * ballAcross;
            if (!(change > 0)) {
                break;
            }
            double step = -f / change;
            turnTo(nx - step * ny, ny + step * nx);
        }
        clamp();
    }

    /**
     * Moves to where the reflected line passes the ball's centre at this distance.
     *
     * @return whether Newton's method was near it before its last step
     */
    private boolean toEdge(double distance) {
        double off = Double.POSITIVE_INFINITY;
        for (int k = 0; k < STEPS_TO_EDGE; k++) {
            reflect();
            if (!(slope < 0)) {
                return false;
            }
            off = distance - miss;
            double step = off / slope;
            turnTo(nx - step * ny, ny + step * nx);
            clamp();
        }
        return Math.abs(off) < NEAR * radius;
    }

    /** Moves to a point of the mirror, given by a vector of any length. */
    private void turnTo(double x, double y) {
        double scale = 1 / Math.sqrt(x * x + y * y);
        nx = x * scale;
        ny = y * scale;
    }

    /** Moves back to the visible part of the mirror, between axis and limb. */
    private void clamp() {
        if (ny < 0) {
            nx = 1;
            ny = 0;
        } else if (!(nx * eye > 1)) {
            toLimb();
        }
    }

    /** Computes the line that is reflected at the current point. */
    private void reflect() {
        double lx = nx - eye;
        double ly = ny;
        double length = Math.sqrt(lx * lx + ly * ly);
        lx /= length;
        ly /= length;
        double cosine = Math.max(-(lx * nx + ly * ny), 0);
        double rx = Math.fma(2 * cosine, nx, lx);
        double ry = Math.fma(2 * cosine, ny, ly);
        double qx = bx - nx;
        double qy = by - ny;
        miss = rx * qy - ry * qx;
        on = rx * qx + ry * qy;
        slope = -(cosine * (1 + on / length) + 2 * on);
    }

    /** 1 − cosine of the angle between the axis and the line to the point of the mirror, in a form without cancellation at small angles. */
    private double height() {
        double lx = eye - nx;
        double square = lx * lx + ny * ny;
        return ny * ny / (square + lx * Math.sqrt(square));
    }

    /** Samples a direction uniformly over the sector's solid angle. */
    void sample(double u, double v) {
        double height = Math.fma(u, greatest - least, least);
        double sine = Math.sqrt(Math.max(height * (2 - height), 0));
        double angle = (2 * v - 1) * turn;
        double a = sine * StrictMath.cos(angle);
        double b = sine * StrictMath.sin(angle);
        double c = 1 - height;
        dx = c * ax + a * ux + b * vx;
        dy = c * ay + a * uy + b * vy;
        dz = c * az + a * uz + b * vz;
    }

    /** Whether a unit vector lies in the sector that the last {@link #aim} found. */
    boolean contains(double x, double y, double z) {
        double along = x * ax + y * ay + z * az;
        double a = x * ux + y * uy + z * uz;
        double b = x * vx + y * vy + z * vz;
        double square = a * a + b * b;
        double height = along > 0 ? square / (1 + along) : 1 - along;
        return height >= least && height <= greatest && a >= turnCosine * Math.sqrt(square);
    }
}
