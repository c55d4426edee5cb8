package enlightenment.transport.ray;

import enlightenment.emitter.SurfacePoint;
import enlightenment.frame.Basis;
import enlightenment.primitive.EndFaces;
import enlightenment.primitive.Hit;
import enlightenment.primitive.Ray;
import enlightenment.world.light.PhysicalLight;

/** Samples the first ray of light paths: a light, a point on it, and a direction. A mutable work object, one per thread. */
public abstract class PathSource {
    /** The number of random numbers that a start takes. */
    public static final int NUMBERS = 6;

    private static final int[] EMPTY_SPACE = {};

    protected final Basis basis = new Basis();
    protected final SurfacePoint point = new SurfacePoint();
    protected final double[] disk = new double[3];
    protected final Ray probe = new Ray();
    private final double[] relative = new double[3];
    private final Hit textured = new Hit();

    /** The direction of emission, a unit vector in the frame. */
    public double dx;

    public double dy;
    public double dz;

    /** The emitted power over the density of the sample, by band: the initial throughput. */
    public double red;

    public double green;
    public double blue;
    public double ultraviolet;

    /** The index of the light that the path begins at. */
    public int light;

    /**
     * Starts a path.
     *
     * @param numbers a point of the unit cube of dimension {@link #NUMBERS}; each pair, from the first number on, is stratified over its
     *     square
     * @param ray receives the first ray
     * @return false if these numbers give no light
     */
    public abstract boolean emit(double[] numbers, Ray ray);

    /** The ids of the solids of glass that the last path may begin in. */
    protected int[] media() {
        return EMPTY_SPACE;
    }

    /** The faces that the light of the last path lies on; null if it has no position. */
    protected abstract EndFaces faces();

    /** The sum of the throughput over the visible bands, plus ultraviolet times this factor. */
    public final double power(double ofUltraviolet) {
        double visible = red + green + blue;
        return ofUltraviolet > 0 ? Math.fma(ofUltraviolet, ultraviolet, visible) : visible;
    }

    /**
     * Starts the ray at the sampled point of a light with a surface, on one side of it.
     *
     * @return false if another surface covers the light there
     */
    protected final boolean leave(PhysicalLight l, int side, Ray ray) {
        ray.set(point.x, point.y, point.z, dx, dy, dz, 0).from(l.surface, side);
        if (l.lyingOn().isCovered(ray, side, point.nx, point.ny, point.nz, probe)) {
            return false;
        }
        l.lyingOn().startOn(ray, side, point.nx, point.ny, point.nz, probe);
        return true;
    }

    /**
     * Multiplies the throughput by the relative intensity of the direction, if the light has a profile; ultraviolet by the factor of blue.
     */
    protected final void weighByProfile(PhysicalLight l) {
        if (l.profile != null) {
            l.profile.intensity(dx, dy, dz, relative);
            weigh();
        }
    }

    /** Multiplies the throughput by the texture's factor at the light's point; ultraviolet by the factor of blue. */
    protected final void weighByTexture(PhysicalLight l, double x, double y, double z) {
        if (l.texture != null) {
            l.texture.factor(x, y, z, textured, relative);
            weigh();
        }
    }

    private void weigh() {
        red *= relative[0];
        green *= relative[1];
        blue *= relative[2];
        ultraviolet *= relative[2];
    }

    /** Sets the direction to (a, b, c) in a basis of which w is the third vector. */
    protected final void direct(double wx, double wy, double wz, double a, double b, double c) {
        basis.around(wx, wy, wz);
        dx = Math.fma(a, basis.ax, Math.fma(b, basis.bx, c * wx));
        dy = Math.fma(a, basis.ay, Math.fma(b, basis.by, c * wy));
        dz = Math.fma(a, basis.az, Math.fma(b, basis.bz, c * wz));
        double scale = 1 / Math.sqrt(dx * dx + dy * dy + dz * dz);
        dx *= scale;
        dy *= scale;
        dz *= scale;
    }
}
