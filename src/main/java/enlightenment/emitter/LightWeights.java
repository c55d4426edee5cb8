package enlightenment.emitter;

import enlightenment.math.Vec3;

/**
 * Estimates the unoccluded contribution of lights to a receiver, roughly and quickly: 0 only where the contribution is 0, as that is
 * decided by bounds, not by midpoints. Balls: the closed form. Others: power times the cosines possible for their bounding ball, over the
 * squared distance.
 */
final class LightWeights {
    private static final int BALL = 0;
    private static final int FLAT = 1;
    private static final int FLAT_TWO_SIDED = 2;
    private static final int CURVED = 3;
    private static final int POINT = 4;

    /** The closed form of a polygon is used within this many radii of its bounding ball. */
    private static final double NEAR = 4;

    /** The share of the rough weight, which is certainly above 0, that is added to the closed form. */
    private static final double SHARE = 0x1p-10;

    private static final int STRIDE = 8;

    /** The least squared distance of a light, so that inverse squares stay finite. */
    static final double LEAST_SQUARE = 0x1p-900;

    private final int[] kinds;

    /** By light: a polygon, which has a closed form; null for others. */
    private final AreaLight[] polygons;

    /** By light: the profile of intensity; null for lights with extent, and for points that emit equally in all directions. */
    private final IntensityProfile[] profiles;

    /** By light: the ball's centre and radius, the normal, and luminance times area. */
    private final double[] data;

    LightWeights(int count) {
        kinds = new int[count];
        polygons = new AreaLight[count];
        profiles = new IntensityProfile[count];
        data = new double[STRIDE * count];
    }

    void set(int i, AreaLight light, double luminance) {
        Vec3 n = light.flatNormal();
        boolean flat = n.maxAbs() > 0;
        kinds[i] = light instanceof SphereLight ? BALL : !flat ? CURVED : light.isTwoSided() ? FLAT_TWO_SIDED : FLAT;
        polygons[i] = light instanceof ParallelogramLight || light instanceof TriangleLight ? light : null;
        // The mean projected area of a closed convex surface is a quarter of its area.
        double strength = kinds[i] == BALL ? luminance : luminance * light.area() * (flat ? 1 : 0.25);
        put(i, light.ballCenter(), light.ballRadius(), n, strength);
    }

    void setPoint(int i, Vec3 position, IntensityProfile profile, double intensity) {
        kinds[i] = POINT;
        profiles[i] = profile;
        put(i, position, 0, Vec3.ZERO, intensity);
    }

    private void put(int i, Vec3 center, double radius, Vec3 normal, double strength) {
        int k = STRIDE * i;
        data[k] = center.x();
        data[k + 1] = center.y();
        data[k + 2] = center.z();
        data[k + 3] = radius;
        data[k + 4] = normal.x();
        data[k + 5] = normal.y();
        data[k + 6] = normal.z();
        data[k + 7] = strength;
    }

    /** For each light, what it is: one of the kinds above. Not to be changed. */
    int[] kinds() {
        return kinds;
    }

    /** For each light, its numbers. Not to be changed. */
    double[] data() {
        return data;
    }

    /** Light i as a leaf of a {@link LightTree}. */
    LightNode leaf(int i) {
        int k = STRIDE * i;
        Vec3 center = new Vec3(data[k], data[k + 1], data[k + 2]);
        Vec3 normal = kinds[i] == FLAT ? new Vec3(data[k + 4], data[k + 5], data[k + 6]) : Vec3.ZERO;
        if (profiles[i] != null) {
            return LightNode.leaf(center, profiles[i], data[k + 7], i);
        }
        double strength = kinds[i] == BALL ? Math.PI * data[k + 3] * data[k + 3] * data[k + 7] : data[k + 7];
        return LightNode.leaf(center, data[k + 3], normal, strength, i);
    }

    /**
     * The weight of light i for a receiver with the unit normal n.
     *
     * @param nx 0, as the other components, for a receiver that receives light from all sides
     */
    double weight(int i, double x, double y, double z, double nx, double ny, double nz, LightSample scratch) {
        int k = STRIDE * i;
        double dx = data[k] - x;
        double dy = data[k + 1] - y;
        double dz = data[k + 2] - z;
        double square = dx * dx + dy * dy + dz * dz;
        double height = nx * dx + ny * dy + nz * dz;
        boolean everywhere = nx == 0 && ny == 0 && nz == 0;
        double radius = data[k + 3];
        double strength = data[k + 7];
        int kind = kinds[i];
        if (kind == BALL) {
            return strength * ball(square, height, radius, everywhere);
        }
        double rough = rough(k, kind, dx, dy, dz, square, height, everywhere);
        if (profiles[i] != null && rough > 0) {
            double inverse = -1 / Math.sqrt(square);
            return rough * profiles[i].luminance(dx * inverse, dy * inverse, dz * inverse);
        }
        if (rough > 0 && !everywhere && polygons[i] != null && square < NEAR * NEAR * radius * radius) {
            AreaLight light = polygons[i];
            light.aim(scratch, x, y, z);
            return strength / light.area() * light.irradiance(scratch, nx, ny, nz) + SHARE * rough;
        }
        return rough;
    }

    private double rough(
            int k, int kind, double dx, double dy, double dz, double square, double height, boolean everywhere) {
        double radius = data[k + 3];
        double strength = data[k + 7];
        double distance = Math.sqrt(square);
        if (kind == FLAT || kind == FLAT_TWO_SIDED) {
            double side = -(data[k + 4] * dx + data[k + 5] * dy + data[k + 6] * dz);
            side = kind == FLAT ? side : Math.abs(side);
            if (!(side > 0)) {
                return 0;
            }
            strength *= side / Math.max(side, distance - radius);
        }
        double cosine = everywhere ? 1 : cosine(height, radius, distance);
        return strength * cosine / Math.max(Math.max(square, radius * radius), LEAST_SQUARE);
    }

    private static double ball(double square, double height, double radius, boolean everywhere) {
        double distance = Math.sqrt(square);
        if (!(distance > radius)) {
            return 0;
        }
        double s = radius / distance;
        if (everywhere) {
            return Math.PI * s * s;
        }
        double k = height / distance;
        if (k >= s) {
            return Math.PI * k * s * s;
        }
        return k <= -s
                ? 0
                : SphereIrradiance.cut(s, Math.sqrt((distance - radius) * (distance + radius)) / distance, k);
    }

    /** The mean of the ball's heights, 0 for those below the horizon, over the distance; at most 1. */
    private static double cosine(double height, double radius, double distance) {
        if (height >= radius) {
            return distance > 0 ? height / distance : 0;
        }
        double reach = height + radius;
        return reach > 0 ? Math.min(reach * reach / (4 * radius * distance), 1) : 0;
    }
}
