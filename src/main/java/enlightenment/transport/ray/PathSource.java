package enlightenment.transport.ray;

import enlightenment.emitter.SurfacePoint;
import enlightenment.frame.Basis;
import enlightenment.primitive.EndFaces;
import enlightenment.primitive.Hit;
import enlightenment.primitive.Ray;
import enlightenment.world.light.PhysicalLight;

/** Starts paths of light: chooses a light, a point on it and a direction. A mutable work object, one per thread. */
public abstract class PathSource {
    /** How many random numbers a start takes. */
    public static final int NUMBERS = 6;

    private static final int[] EMPTY_SPACE = {};

    protected final Basis basis = new Basis();
    protected final SurfacePoint point = new SurfacePoint();
    protected final double[] disk = new double[3];
    protected final Ray probe = new Ray();
    private final double[] relative = new double[3];
    private final Hit textured = new Hit();

    /** The direction. */
    public double dx;

    public double dy;
    public double dz;

    /** The power that a path with these numbers brings, over the density of these: by band. */
    public double red;

    public double green;
    public double blue;
    public double ultraviolet;

    /** The light that the path leaves, by its index. */
    public int light;

    /**
     * Starts a path.
     *
     * @param numbers of the unit cube, {@link #NUMBERS} of them; each two of them from the first on are spread evenly over their square
     * @param ray receives its first ray
     * @return false if no light goes this way
     */
    public abstract boolean emit(double[] numbers, Ray ray);

    /** The solids of glass that the path that was started last may begin in. */
    protected int[] media() {
        return EMPTY_SPACE;
    }

    /** The faces that the light which the path leaves lies on; null if it has no place. */
    protected abstract EndFaces faces();

    /** The sum of the bands, of ultraviolet as much as this. */
    public final double power(double ofUltraviolet) {
        double visible = red + green + blue;
        return ofUltraviolet > 0 ? Math.fma(ofUltraviolet, ultraviolet, visible) : visible;
    }

    /**
     * Starts the ray in the direction from the point of a light with a surface, on a side of that.
     *
     * @return false if the light is covered there
     */
    protected final boolean leave(PhysicalLight l, int side, Ray ray) {
        ray.set(point.x, point.y, point.z, dx, dy, dz, 0).from(l.surface, side);
        if (l.lyingOn().isCovered(ray, side, point.nx, point.ny, point.nz, probe)) {
            return false;
        }
        l.lyingOn().startOn(ray, side, point.nx, point.ny, point.nz, probe);
        return true;
    }

    /** Multiplies what the path brings by the relative intensity of its direction, if the light has a profile; of ultraviolet as of blue. */
    protected final void weighByProfile(PhysicalLight l) {
        if (l.profile != null) {
            l.profile.intensity(dx, dy, dz, relative);
            weigh();
        }
    }

    /** Multiplies what the path brings by the factor of a textured light's point; of ultraviolet as of blue. */
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
