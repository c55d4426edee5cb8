package enlightenment.emitter;

import enlightenment.math.Vec3;

/** Lights made larger by a factor. */
final class Scaled {
    private Scaled() {}

    static AreaLight by(AreaLight light, double f) {
        double[] p = light.parameters();
        LightSides sides = LightSides.values()[p.length % 3 == 1 ? (int) p[p.length - 1] : 0];
        Vec3 a = vector(p, 0, f);
        if (light instanceof SphereLight) {
            return new SphereLight(a, f * p[3]);
        } else if (light instanceof InnerSphereLight) {
            return new InnerSphereLight(a, f * p[3]);
        } else if (light instanceof ParallelogramLight) {
            return new ParallelogramLight(a, vector(p, 1, f), vector(p, 2, f), sides);
        } else if (light instanceof TriangleLight) {
            return new TriangleLight(a, a.plus(vector(p, 1, f)), a.plus(vector(p, 2, f)), sides);
        } else if (light instanceof DiskLight) {
            return new DiskLight(a, vector(p, 1, 1), f * p[6], sides);
        } else if (light instanceof LateralLight) {
            return new LateralLight(a, vector(p, 1, f), f * p[6], f * p[7], sides);
        }
        return new TorusLight(a, vector(p, 1, 1), f * p[6], f * p[7], sides);
    }

    private static Vec3 vector(double[] p, int k, double f) {
        return new Vec3(f * p[3 * k], f * p[3 * k + 1], f * p[3 * k + 2]);
    }
}
