package enlightenment.emitter;

import enlightenment.math.Vec3;
import enlightenment.numeric.Scale;

/** A parallelogram that emits from both sides, sampled uniformly over its area. */
public final class RectangleEmitter implements Emitter {
    private final Vec3 corner;
    private final Vec3 right;
    private final Vec3 up;

    /** The normal with the area as its length. */
    private final Vec3 area;

    /**
     * Makes a parallelogram.
     *
     * @param corner its lower left corner
     * @param right the edge from there to the lower right one
     * @param up the edge to the upper left one
     */
    public RectangleEmitter(Vec3 corner, Vec3 right, Vec3 up) {
        this.corner = corner;
        this.right = right;
        this.up = up;
        area = right.cross(up);
    }

    @Override
    public Vec3 ballCenter() {
        return corner.plus(right.plus(up).times(0.5));
    }

    @Override
    public double ballRadius() {
        double diagonal = Math.max(right.plus(up).length(), right.minus(up).length());
        return 0.5 * diagonal * (1 + Scale.gamma(16));
    }

    @Override
    public boolean isDelta() {
        return false;
    }

    @Override
    public void sample(EmitterView view, double u, double v) {
        double x = Math.fma(u, right.x(), Math.fma(v, up.x(), corner.x() - view.cone.x));
        double y = Math.fma(u, right.y(), Math.fma(v, up.y(), corner.y() - view.cone.y));
        double z = Math.fma(u, right.z(), Math.fma(v, up.z(), corner.z() - view.cone.z));
        double len = Math.sqrt(x * x + y * y + z * z);
        double inverse = len == 0 ? 0 : 1 / len;
        view.set(x * inverse, y * inverse, z * inverse, len);
    }

    @Override
    public double pdf(EmitterView view) {
        return pdf(view.length, view.dx * area.x() + view.dy * area.y() + view.dz * area.z());
    }

    /** Converts density per area to density per solid angle: distance² / (area · cosine at the emitter). */
    private static double pdf(double distance, double areaAlong) {
        return distance > 0 ? distance * distance / Math.abs(areaAlong) : 0;
    }

    @Override
    public double pdf(EmitterView view, double x, double y, double z) {
        Vec3 d = new Vec3(x, y, z);
        Vec3 toCorner = corner.minus(new Vec3(view.cone.x, view.cone.y, view.cone.z));
        double areaAlong = d.dot(area);
        double distance = toCorner.dot(area) / areaAlong;
        if (!(distance > 0 && distance < Double.POSITIVE_INFINITY)) {
            return 0;
        }
        Vec3 there = d.times(distance).minus(toCorner);
        double square = area.dot(area);
        double u = there.cross(up).dot(area) / square;
        double v = right.cross(there).dot(area) / square;
        return u >= 0 && u <= 1 && v >= 0 && v <= 1 ? pdf(distance, areaAlong) : 0;
    }

    /** NaN above the horizon: Lambert's closed form would be the mean over solid angle; samples have the mean over the area. */
    @Override
    public double meanCosine(EmitterView view, double nx, double ny, double nz) {
        double there =
                nx * (corner.x() - view.cone.x) + ny * (corner.y() - view.cone.y) + nz * (corner.z() - view.cone.z);
        double toRight = nx * right.x() + ny * right.y() + nz * right.z();
        double toTop = nx * up.x() + ny * up.y() + nz * up.z();
        return there + Math.max(toRight, 0) + Math.max(toTop, 0) <= 0 ? 0 : Double.NaN;
    }

    @Override
    public void prepareByCosine(EmitterView view, double nx, double ny, double nz) {
        throw noClosedForm();
    }

    @Override
    public void sampleByCosine(EmitterView view, double u, double v) {
        throw noClosedForm();
    }

    @Override
    public void sampleDisk(EmitterView view, double p, double q) {
        throw noClosedForm();
    }

    private static IllegalStateException noClosedForm() {
        return new IllegalStateException("a rectangle has no closed form of its mean cosine");
    }
}
