package enlightenment.world.camera;

import enlightenment.math.Vec3;
import enlightenment.primitive.Ray;

/**
 * Projects to affine cameras. With rays from one eye, g(x, y) = g₀ + x·gₓ + y·g_y at the place (x, y) of the picture, a solid angle dω around
 * g covers |g|³/|det(g₀, gₓ, g_y)| dω of the picture; with parallel rays g that start at o₀ + x·oₓ + y·o_y, an area dA across them covers
 * |g|/|det(g, oₓ, o_y)| dA. The determinant does not depend on the place. (Perspective: P. Dutré, E. Lafortune, Y. Willems, "Monte Carlo
 * light tracing with direct computation of pixel intensities", 1993, for oblique windows, too.)
 *
 * <p>At a point of a lens the directions are g(x, y) − l with a vector l that is parallel to gₓ and g_y: the determinant is the same, and
 * places are shifted by what l is in these two.
 */
final class AffineProjection extends EyeProjection {
    /** Down to this distance from the eye nothing underflows where it is cubed. */
    private static final double SMALL = 0x1p-300;

    private final Vec3 middle;
    private final ThinLens lens;

    /** The eye: the middle of the lens, or the sampled point of it. */
    private Vec3 start;

    /** The shift of the film position by the sampled point of the lens. */
    private double shiftX;

    private double shiftY;

    /** The rows of the adjugate of the camera's matrix: for the distance along the ray, x and y. */
    private final Vec3 along;

    private final Vec3 across;
    private final Vec3 down;
    private final double determinant;
    private final boolean isParallel;
    private final Vec3 parallel;
    private final double tMin;

    AffineProjection(AffineCamera camera) {
        lens = camera.lens;
        middle = camera.origin;
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

    @Override
    public boolean hasSeveralStarts() {
        return lens != null;
    }

    @Override
    public void sampleStart(double u, double v) {
        if (lens == null) {
            return;
        }
        double[] point = lens.sample(u, v);
        Vec3 turn = lens.turn(point);
        start = middle.plus(lens.start(point));
        shiftX = across.dot(turn) / determinant;
        shiftY = down.dot(turn) / determinant;
    }

    @Override
    public void startWith(Ray camera) {
        if (lens != null) {
            start = new Vec3(camera.ox, camera.oy, camera.oz);
        }
    }

    @Override
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
        x = dot(across, qx, qy, qz) / scale + shiftX;
        y = dot(down, qx, qy, qz) / scale + shiftY;
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

    /** Whether a point at this distance along its ray is where the ray starts, within rounding; never if all rays start at the eye. */
    private boolean isWhereRaysStart(double s) {
        return isParallel ? (tMin - s) * parallel.length() <= error : tMin > 0 && tMin - s <= ERROR * tMin;
    }

    @Override
    public boolean place(double px, double py, double pz) {
        double qx = px - start.x();
        double qy = py - start.y();
        double qz = pz - start.z();
        double depth = dot(along, qx, qy, qz);
        double scale = isParallel ? determinant : depth;
        x = dot(across, qx, qy, qz) / scale + shiftX;
        y = dot(down, qx, qy, qz) / scale + shiftY;
        return isParallel || depth / determinant > 0;
    }

    @Override
    public Vec3 start() {
        return middle;
    }

    @Override
    public boolean isParallel() {
        return isParallel;
    }

    @Override
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

    /** The importance at this distance from the eye, for a direction in the camera's axes. */
    private double importance(double s, double qx, double qy, double qz) {
        if (s > SMALL) {
            return Math.sqrt(qx * qx + qy * qy + qz * qz) / (s * s * s * Math.abs(determinant));
        }
        // In a larger unit of length: cubes of lengths that are tiny beside the scene are beyond the range of doubles.
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
