package enlightenment.shading;

import enlightenment.compiled.PhysicalLight;
import enlightenment.emitter.SurfacePoint;
import enlightenment.frame.Basis;
import enlightenment.primitive.EndFaces;
import enlightenment.primitive.Ray;

/** Starts paths of light: chooses a light, a point on it and a direction. A mutable work object, one per thread. */
abstract class PathSource {
    /** How many random numbers a start takes. */
    static final int NUMBERS = 6;

    private static final int[] EMPTY_SPACE = {};

    final Basis basis = new Basis();
    final SurfacePoint point = new SurfacePoint();
    final double[] disk = new double[3];
    final Ray probe = new Ray();

    /** The direction. */
    double dx;

    double dy;
    double dz;

    /** The power that a path with these numbers brings, over the density of these: by band. */
    double red;

    double green;
    double blue;
    double ultraviolet;

    /** The light that the path leaves, by its index. */
    int light;

    /**
     * Starts a path.
     *
     * @param numbers of the unit cube, {@link #NUMBERS} of them; each two of them from the first on are spread evenly over their square
     * @param ray receives its first ray
     * @return false if no light goes this way
     */
    abstract boolean emit(double[] numbers, Ray ray);

    /** The solids of glass that the path that was started last may begin in. */
    int[] media() {
        return EMPTY_SPACE;
    }

    /** The faces that the light which the path leaves lies on; null if it has no place. */
    abstract EndFaces faces();

    /** The sum of the bands, of ultraviolet as much as this. */
    final double power(double ofUltraviolet) {
        double visible = red + green + blue;
        return ofUltraviolet > 0 ? Math.fma(ofUltraviolet, ultraviolet, visible) : visible;
    }

    /**
     * Starts the ray in the direction from the point of a light with a surface, on a side of that.
     *
     * @return false if the light is covered there
     */
    final boolean leave(PhysicalLight l, int side, Ray ray) {
        ray.set(point.x, point.y, point.z, dx, dy, dz, 0).from(l.surface, side);
        if (l.lyingOn().isCovered(ray, side, point.nx, point.ny, point.nz, probe)) {
            return false;
        }
        l.lyingOn().startOn(ray, side, point.nx, point.ny, point.nz, probe);
        return true;
    }

    /** Sets the direction to (a, b, c) in a basis of which w is the third vector. */
    final void direct(double wx, double wy, double wz, double a, double b, double c) {
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
