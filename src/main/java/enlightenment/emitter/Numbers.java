package enlightenment.emitter;

import enlightenment.math.Vec3;

/** The numbers of a light in one array. */
final class Numbers {
    private Numbers() {}

    static double[] of(LightSides sides, Vec3... vectors) {
        double[] all = new double[3 * vectors.length + 1];
        for (int k = 0; k < vectors.length; k++) {
            all[3 * k] = vectors[k].x();
            all[3 * k + 1] = vectors[k].y();
            all[3 * k + 2] = vectors[k].z();
        }
        all[3 * vectors.length] = sides.ordinal();
        return all;
    }
}
