package enlightenment.world.camera;

import enlightenment.math.Vec3;
import enlightenment.numeric.Scale;

/**
 * Where in the picture the camera sees a point, and how much of the picture light that leaves it covers: the camera's rays the other way
 * round, for paths that come from a light. A mutable work object, one per thread.
 *
 * <p>Cameras are affine. With rays from one eye, g(x, y) = g₀ + x·gₓ + y·g_y at the place (x, y) of the picture, a solid angle dω around
 * g covers |g|³/|det(g₀, gₓ, g_y)| dω of the picture; with parallel rays g that start at o₀ + x·oₓ + y·o_y, an area dA across them covers
 * |g|/|det(g, oₓ, o_y)| dA. The determinant does not depend on the place. (Perspective: P. Dutré, E. Lafortune, Y. Willems, "Monte Carlo
 * light tracing with direct computation of pixel intensities", 1993, for oblique windows, too.)
 */
public final class EyeProjection {
    /** Down to this distance from the eye nothing underflows where it is cubed. */
    private static final double SMALL = 0x1p-300;

    private static final double ERROR = Scale.gamma(64);

    private final Vec3 start;

    /** The rows of the inverse of the camera's matrix times its determinant: for how far along the ray, x and y. */
    private final Vec3 along;

    private final Vec3 across;
    private final Vec3 down;
    private final double determinant;
    private final boolean isParallel;
    private final Vec3 parallel;
    private final double tMin;

    /** The place in the picture, 0..1 from the left. */
    public double x;

    /** From above, 0..1. */
    public double y;

    /** The vector from the point to where the camera's ray begins: what lies between hides the point. */
    public double toEyeX;

    public double toEyeY;
    public double toEyeZ;

    /** How far that vector's end may be from there by rounding, or a surface that the camera's ray begins on: a generous bound. */
    public double error;

    /** The unit vector in that direction. */
    public double dx;

    public double dy;
    public double dz;

    /**
     * The factor that turns β·f·cosθ at the point into the contribution to the picture ({@code SplatBatch.add}): for a light path of
     * power β at a surface with BSDF f towards the eye, θ the angle between that direction and the normal. It is picture area (1 for the
     * whole picture) per area perpendicular to the connection: |g|³/(|det(g₀, gₓ, g_y)| d²) for an eye at distance d in the frame,
     * |g|/|det(g, oₓ, o_y)| for parallel rays.
     */
    public double importance;

    /** For the camera of a scene. */
    public EyeProjection(CompiledCamera camera) {
        isParallel = camera.directionX.maxAbs() == 0 && camera.directionY.maxAbs() == 0;
        start = camera.origin;
        parallel = camera.direction;
        tMin = camera.tMin;
        Vec3 g = camera.direction;
        Vec3 gx = isParallel ? camera.originX : camera.directionX;
        Vec3 gy = isParallel ? camera.originY : camera.directionY;
        along = gx.cross(gy);
        across = gy.cross(g);
        down = g.cross(gx);
        determinant = g.dot(along);
    }

    /**
     * Projects a point of the frame.
     *
     * @return whether it lies where the camera's rays go, within the picture; otherwise what was set is of no use
     */
    public boolean project(double px, double py, double pz) {
        double qx = px - start.x();
        double qy = py - start.y();
        double qz = pz - start.z();
        double s = dot(along, qx, qy, qz) / determinant;
        double size = Math.max(Math.max(Math.abs(px), Math.abs(py)), Math.abs(pz));
        error = ERROR * (size + start.maxAbs());
        if (!(s > tMin) && !isWhereRaysStart(s)) {
            return false;
        }
        double scale = isParallel ? determinant : s * determinant;
        x = dot(across, qx, qy, qz) / scale;
        y = dot(down, qx, qy, qz) / scale;
        if (!(x >= 0 && x < 1 && y >= 0 && y < 1)) {
            return false;
        }
        if (isParallel) {
            turn(parallel.x(), parallel.y(), parallel.z(), s - tMin);
            importance = parallel.length() / Math.abs(determinant);
        } else {
            turn(qx, qy, qz, 1 - tMin / s);
            importance = importance(s, qx, qy, qz);
        }
        return true;
    }

    /** Whether a point so far along a ray is where that starts, as far as rounding tells: not of rays that all start at the eye. */
    private boolean isWhereRaysStart(double s) {
        return isParallel ? (tMin - s) * parallel.length() <= error : tMin > 0 && tMin - s <= ERROR * tMin;
    }

    /**
     * Where a point of the frame appears, in the picture or beside it, whether it can be seen or not.
     *
     * @return whether it lies before the eye; parallel rays have no eye, and everything is before them
     */
    public boolean place(double px, double py, double pz) {
        double qx = px - start.x();
        double qy = py - start.y();
        double qz = pz - start.z();
        double depth = dot(along, qx, qy, qz);
        double scale = isParallel ? determinant : depth;
        x = dot(across, qx, qy, qz) / scale;
        y = dot(down, qx, qy, qz) / scale;
        return isParallel || depth / determinant > 0;
    }

    /** The eye, in the frame, where all rays come from one; of parallel rays where that of the picture's upper left corner starts. */
    public Vec3 start() {
        return start;
    }

    /** Whether all rays have the same direction. */
    public boolean isParallel() {
        return isParallel;
    }

    /** The {@link #importance} of a point that the camera is known to see. */
    public double importanceOf(double px, double py, double pz) {
        if (isParallel) {
            return parallel.length() / Math.abs(determinant);
        }
        double qx = px - start.x();
        double qy = py - start.y();
        double qz = pz - start.z();
        double s = dot(along, qx, qy, qz) / determinant;
        return importance(s, qx, qy, qz);
    }

    /** For an eye at this distance, in the camera's directions and as a vector. */
    private double importance(double s, double qx, double qy, double qz) {
        if (s > SMALL) {
            return Math.sqrt(qx * qx + qy * qy + qz * qz) / (s * s * s * Math.abs(determinant));
        }
        // The same in a larger unit of length: cubes of what is small beside the whole scene are beyond the range of
        // doubles.
        double x = qx / SMALL;
        double y = qy / SMALL;
        double z = qz / SMALL;
        double t = s / SMALL;
        return Math.sqrt(x * x + y * y + z * z) / (t * t * t * Math.abs(determinant)) / SMALL / SMALL;
    }

    private void turn(double vx, double vy, double vz, double part) {
        toEyeX = -vx * part;
        toEyeY = -vy * part;
        toEyeZ = -vz * part;
        double inverse = 1 / Math.sqrt(vx * vx + vy * vy + vz * vz);
        dx = -vx * inverse;
        dy = -vy * inverse;
        dz = -vz * inverse;
    }

    private static double dot(Vec3 v, double x, double y, double z) {
        return v.x() * x + v.y() * y + v.z() * z;
    }
}
