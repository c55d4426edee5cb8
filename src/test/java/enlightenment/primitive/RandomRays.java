package enlightenment.primitive;

import enlightenment.frame.Rotation;
import enlightenment.math.Vec3;
import java.util.SplittableRandom;

/** Reproducible random geometry for tests. */
final class RandomRays {
    private final SplittableRandom random;

    RandomRays(long seed) {
        random = new SplittableRandom(seed);
    }

    double uniform() {
        return random.nextDouble();
    }

    int index(int n) {
        return random.nextInt(n);
    }

    double signed() {
        return 2 * random.nextDouble() - 1;
    }

    Vec3 inCube() {
        return new Vec3(signed(), signed(), signed());
    }

    Vec3 direction() {
        Vec3 v = inCube();
        return v.lengthSquared() > 1 || v.lengthSquared() < 0.01 ? direction() : v.normalized();
    }

    /** ±10^k with k evenly spread between lo and hi. */
    double decade(double lo, double hi) {
        double v = StrictMath.pow(10, lo + (hi - lo) * random.nextDouble());
        return random.nextBoolean() ? v : -v;
    }

    Rotation rotation() {
        return Rotation.ofDegrees(inCube().times(180));
    }

    /** A direction that leaves a surface on the side of its normal n, at the given cosine to it. */
    Vec3 leaving(Vec3 n, double cosine) {
        Vec3 tangent = n.cross(direction());
        return tangent.maxAbs() < 0.1
                ? leaving(n, cosine)
                : tangent.normalized()
                        .times(Math.sqrt((1 - cosine) * (1 + cosine)))
                        .plus(n.times(cosine));
    }
}
