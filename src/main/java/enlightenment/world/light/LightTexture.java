package enlightenment.world.light;

import enlightenment.color.Rgb;
import enlightenment.emitter.AreaLight;
import enlightenment.emitter.SurfacePoint;
import enlightenment.math.Vec3;
import enlightenment.primitive.Hit;
import enlightenment.primitive.Primitive;
import enlightenment.primitive.Ray;
import enlightenment.primitive.SupportSurface;
import enlightenment.primitive.TrianglePrimitive;
import enlightenment.world.material.RadianceMap;

/** The texture of a light with a surface: the factor of its radiance at each point. Immutable, shared by threads. */
public final class LightTexture {
    /** The least and the largest number of points on each side of the grid that the mean is taken over. */
    private static final int LEAST_SIDE = 4;

    private static final int MOST_SIDE = 64;

    /**
     * The mean of a band is at least this share of its largest factor, as grid points may miss small emitting parts, which must be sampled
     * as well.
     */
    private static final double LEAST_SHARE = 1.0 / 64;

    private final RadianceMap map;
    private final Primitive surface;
    private final int face;
    private final SupportSurface support;

    LightTexture(RadianceMap map, Primitive surface, int face) {
        this.map = map;
        this.surface = surface;
        this.face = face;
        support = surface.support(face);
    }

    /**
     * Writes the factor at a point of the light, by band; that of ultraviolet is blue's.
     *
     * @param hit is overwritten
     */
    public void factor(double x, double y, double z, Hit hit, double[] rgb) {
        hit.primitive = surface;
        hit.face = face;
        hit.side = Ray.OUTSIDE;
        hit.px = x;
        hit.py = y;
        hit.pz = z;
        // Only surfaces without corners have texture coordinates that depend on normals.
        Vec3 outward = support.outward(new Vec3(x, y, z));
        if (outward != null) {
            turn(hit, outward);
        }
        map.factor(hit, rgb);
    }

    private static void turn(Hit hit, Vec3 normal) {
        Vec3 n = normal.normalized();
        hit.nx = n.x();
        hit.ny = n.y();
        hit.nz = n.z();
    }

    /**
     * The mean factor over the light's area, by band, estimated by a grid of points, for sampling of lights. Greater than 0 where the
     * factor is so at any point.
     */
    Rgb mean(AreaLight form) {
        double[] bound = new double[3];
        double texels = bound(bound);
        int side = (int) Math.min(Math.max(Math.ceil(texels), LEAST_SIDE), MOST_SIDE);
        SurfacePoint point = new SurfacePoint();
        Hit hit = new Hit();
        double[] rgb = new double[3];
        double[] sum = new double[3];
        for (int k = 0; k < side * side; k++) {
            form.samplePoint((k % side + 0.5) / side, (k / side + 0.5) / side, point);
            factor(point.x, point.y, point.z, hit, rgb);
            for (int band = 0; band < sum.length; band++) {
                sum[band] += rgb[band];
            }
        }
        double n = side * side;
        return new Rgb(
                Math.max(sum[0] / n, LEAST_SHARE * bound[0]),
                Math.max(sum[1] / n, LEAST_SHARE * bound[1]),
                Math.max(sum[2] / n, LEAST_SHARE * bound[2]));
    }

    /** Writes upper bounds of the factors; returns roughly the number of texels along the light. */
    private double bound(double[] rgb) {
        if (!(surface instanceof TrianglePrimitive)) {
            map.bound(rgb);
            return map.texels(1, 1);
        }
        double[] corners = surface.parameters();
        double[] low = {Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY};
        double[] high = {Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY};
        Hit hit = new Hit();
        for (int k = 0; k < 9; k += 3) {
            hit.px = corners[k];
            hit.py = corners[k + 1];
            hit.pz = corners[k + 2];
            surface.textureCoordinates(hit);
            low[0] = Math.min(low[0], hit.u);
            low[1] = Math.min(low[1], hit.v);
            high[0] = Math.max(high[0], hit.u);
            high[1] = Math.max(high[1], hit.v);
        }
        map.bound(low[0], low[1], high[0], high[1], rgb);
        return map.texels(high[0] - low[0], high[1] - low[1]);
    }
}
