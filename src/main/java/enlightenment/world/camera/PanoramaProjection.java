package enlightenment.world.camera;

import enlightenment.math.Vec3;
import enlightenment.primitive.Ray;

/**
 * Projects to a panorama. A ray of longitude φ starts at a·t and has the direction cosθ·e + sinθ·up, where e is level and has that
 * longitude, t = de/dφ, and a is how far the eye stands to the right of the middle. In the level plane the point is a·t + l·e, so
 * l² = ρ² − a² at a distance ρ from the axis. A point at distance d along the ray moves by d·cosθ and by d across it as φ and θ grow, whatever
 * a is: an area dA across the ray covers dA/(2π² cosθ d²) of a picture that is 2π wide and π high. Of a stereo pair that is half as much,
 * and each eye is chosen with a probability of one half.
 */
final class PanoramaProjection extends EyeProjection {
    private final View view;
    private final boolean isStereo;

    /** The offset of the eye to the right of the middle between the eyes, in the frame. */
    private double offset;

    private Vec3 start = Vec3.ZERO;

    /** The point relative to the middle: its level components, and its height. */
    private double right;

    private double forward;
    private double height;

    /** The components of the level direction of its ray, and the distance along that. */
    private double aheadRight;

    private double aheadForward;
    private double level;

    PanoramaProjection(PanoramaCamera camera) {
        view = camera.view;
        isStereo = camera.offset > 0;
        offset = -camera.offset;
    }

    @Override
    public boolean hasSeveralStarts() {
        return isStereo;
    }

    @Override
    public void sampleStart(double u, double v) {
        offset = u < 0.5 ? -Math.abs(offset) : Math.abs(offset);
    }

    @Override
    public void startWith(Ray camera) {
        start = new Vec3(camera.ox, camera.oy, camera.oz);
    }

    @Override
    public boolean project(double px, double py, double pz) {
        if (!place(px, py, pz)) {
            return false;
        }
        double sx = offset * aheadForward;
        double sz = -offset * aheadRight;
        Vec3 eye = view.right.times(sx).plus(view.forward.times(sz));
        toEyeX = eye.x() - px;
        toEyeY = eye.y() - py;
        toEyeZ = eye.z() - pz;
        double distance = Math.sqrt(level * level + height * height);
        dx = toEyeX / distance;
        dy = toEyeY / distance;
        dz = toEyeZ / distance;
        importance = importance(level, distance);
        error = ERROR * (Math.max(Math.max(Math.abs(px), Math.abs(py)), Math.abs(pz)) + Math.abs(offset));
        return x < 1 && y < (isStereo && offset < 0 ? 0.5 : 1);
    }

    /** Returns false also for points above, below and between the eyes. */
    @Override
    public boolean place(double px, double py, double pz) {
        Vec3 p = new Vec3(px, py, pz);
        right = view.right.dot(p);
        forward = view.forward.dot(p);
        height = view.up.dot(p);
        double axial = Math.sqrt(right * right + forward * forward);
        double beside = Math.abs(offset);
        if (!(axial > beside)) {
            return false;
        }
        level = Math.sqrt((axial - beside) * (axial + beside));
        double square = axial * axial;
        aheadRight = (level * right - offset * forward) / square;
        aheadForward = (level * forward + offset * right) / square;
        x = 0.5 + StrictMath.atan2(aheadRight, aheadForward) / (2 * Math.PI);
        y = 0.5 - StrictMath.atan2(height, level) / Math.PI;
        if (isStereo) {
            y = (offset < 0 ? y : 1 + y) / 2;
        }
        return true;
    }

    @Override
    public Vec3 start() {
        return Vec3.ZERO;
    }

    @Override
    public boolean isParallel() {
        return false;
    }

    @Override
    public double importanceOf(double px, double py, double pz) {
        Vec3 q = new Vec3(px, py, pz).minus(start);
        double a = view.right.dot(q);
        double b = view.forward.dot(q);
        return importance(Math.sqrt(a * a + b * b), q.length());
    }

    private static double importance(double level, double distance) {
        return 1 / (2 * Math.PI * Math.PI) / level / distance;
    }
}
