package enlightenment.primitive;

import enlightenment.math.Vec3;
import java.util.List;
import java.util.SplittableRandom;

/** Random round primitives, points on them and directions, repeatable by their seed. */
final class RoundSamples {
    static final List<String> CONVEX = List.of("sphere", "cylinder", "cone", "frustum", "flare", "disk");

    private final SplittableRandom random;

    RoundSamples(long seed) {
        random = new SplittableRandom(seed);
    }

    double uniform(double lo, double hi) {
        return lo + (hi - lo) * random.nextDouble();
    }

    /** A number whose logarithm is uniform. */
    double magnitude(double lo, double hi) {
        return Math.exp(uniform(Math.log(lo), Math.log(hi)));
    }

    boolean oneIn(int n) {
        return random.nextInt(n) == 0;
    }

    int below(int n) {
        return random.nextInt(n);
    }

    Vec3 direction() {
        while (true) {
            Vec3 v = new Vec3(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1));
            double l = v.length();
            if (l > 0.01 && l <= 1) {
                return v.times(1 / l);
            }
        }
    }

    /** A direction that is parallel to a coordinate axis now and then. */
    Vec3 axis() {
        if (oneIn(4)) {
            double sign = oneIn(2) ? 1 : -1;
            int k = below(3);
            return new Vec3(k == 0 ? sign : 0, k == 1 ? sign : 0, k == 2 ? sign : 0);
        }
        return direction();
    }

    /** A unit direction across the given one. */
    Vec3 across(Vec3 v) {
        return v.cross(direction()).normalized();
    }

    /** A primitive of about the given size at a distance of about {@code shift} from the origin. */
    Primitive primitive(String kind, double size, double shift) {
        Vec3 at = direction().times(shift);
        Vec3 axis = axis().times(size * uniform(0.3, 2));
        double r = size * uniform(0.2, 1);
        return switch (kind) {
            case "sphere" -> new SpherePrimitive(at, r, new Vec3(0, 0, -1));
            case "disk" -> new DiskPrimitive(at, axis, r);
            case "cylinder" -> new CylinderPrimitive(at, at.plus(axis), r, true);
            case "cone" -> new ConePrimitive(at, at.plus(axis), r, 0, true);
            case "frustum" -> new ConePrimitive(at, at.plus(axis), r, r * uniform(0.05, 1), true);
            case "flare" -> new ConePrimitive(at, at.plus(axis), r * uniform(0.05, 1), r, true);
            default -> throw new IllegalArgumentException(kind);
        };
    }

    /** The centre of the primitive's bounds. */
    static Vec3 center(Primitive p) {
        return p.bounds().min().times(0.5).plus(p.bounds().max().times(0.5));
    }

    static double size(Primitive p) {
        return p.bounds().extent().maxAbs();
    }

    /** A point on the surface, as a ray's hit tells it: its normal and face are right, its t and side are not used. */
    Hit surfacePoint(Primitive p) {
        Hit hit = new Hit();
        Vec3 c = center(p);
        double s = size(p);
        while (true) {
            Vec3 target = c.plus(new Vec3(uniform(-0.5, 0.5), uniform(-0.5, 0.5), uniform(-0.5, 0.5)).times(s));
            Vec3 origin = c.plus(direction().times(3 * s));
            Ray ray = Ray.of(origin, target.minus(origin));
            if (p.intersect(ray, hit)) {
                return hit;
            }
        }
    }

    /** A unit direction whose cosine with the normal is the given one. */
    Vec3 leaning(Vec3 normal, double cosine) {
        Vec3 tangent = across(normal);
        return normal.times(cosine).plus(tangent.times(Math.sqrt((1 - cosine) * (1 + cosine))));
    }
}
