package enlightenment.importer.gltf;

import java.io.IOException;

/**
 * Keys of one property of a node (glTF 2.0, section 3.11 and appendix C): vectors, or unit quaternions x, y, z, w.
 *
 * @param times seconds, strictly increasing
 * @param values of each key its numbers; with {@link Kind#CUBICSPLINE} its tangent before it, its value and its tangent after it
 * @param kind how it goes from key to key
 * @param isRotation whether values are quaternions, which are interpolated along the shorter arc
 */
record KeyframeSampler(float[] times, float[] values, Kind kind, boolean isRotation) {
    /** Key times are floats: a time this much earlier, relatively, is that of the key. Four units in the last place. */
    private static final double FLOAT_ROUNDING = 0x1p-21;

    /** Interpolations. */
    enum Kind {
        LINEAR,
        STEP,
        CUBICSPLINE
    }

    /**
     * Reads a sampler of an animation.
     *
     * @throws IOException with its place if keys are not in order, numbers are not finite, or their counts disagree
     */
    static KeyframeSampler read(GltfElement sampler, GltfAccessors accessors, boolean isRotation) throws IOException {
        String word = sampler.text("interpolation", "LINEAR");
        Kind kind =
                switch (word) {
                    case "LINEAR" -> Kind.LINEAR;
                    case "STEP" -> Kind.STEP;
                    case "CUBICSPLINE" -> Kind.CUBICSPLINE;
                    default -> throw sampler.failure("must have the interpolation LINEAR, STEP or CUBICSPLINE");
                };
        float[] times = accessors.numbers(sampler, "input", "SCALAR").values();
        GltfAccessors.Numbers output = accessors.numbers(sampler, "output", isRotation ? "VEC4" : "VEC3");
        for (int i = 0; i < times.length; i++) {
            if (!(times[i] >= (i == 0 ? 0 : Math.nextUp(times[i - 1])) && times[i] < Float.POSITIVE_INFINITY)) {
                throw sampler.failure("input: times of keys must be finite, at least 0 and increasing, and key " + i
                        + " is at " + times[i]);
            }
        }
        int each = kind == Kind.CUBICSPLINE ? 3 : 1;
        if (output.count() != (long) each * times.length) {
            throw sampler.failure(
                    "output: must have " + (long) each * times.length + " elements, not " + output.count());
        }
        for (float v : output.values()) {
            if (!Float.isFinite(v)) {
                throw sampler.failure("output: must be finite numbers");
            }
        }
        return new KeyframeSampler(times, output.values(), kind, isRotation);
    }

    /** The time of the last key, in seconds. */
    double end() {
        return times[times.length - 1];
    }

    /** Whether nothing but straight lines lies between keys, which are all at whole numbers of frames. */
    boolean isLinearByFrames(double framesPerSecond) {
        for (float t : times) {
            double at = t * framesPerSecond;
            if (Math.abs(at - StrictMath.rint(at)) > at * FLOAT_ROUNDING) {
                return false;
            }
        }
        return kind == Kind.LINEAR;
    }

    /** The value at a time in seconds: that of the first key before it, of the last key after it. Quaternions have length 1. */
    double[] at(double time) {
        double reached = time + time * FLOAT_ROUNDING;
        int next = 0;
        int past = times.length;
        while (next < past) {
            int middle = (next + past) >>> 1;
            if (times[middle] <= reached) {
                next = middle + 1;
            } else {
                past = middle;
            }
        }
        int key = Math.max(next - 1, 0);
        if (next == 0 || next == times.length || kind == Kind.STEP) {
            return unit(value(key, kind == Kind.CUBICSPLINE ? 1 : 0));
        }
        double length = (double) times[next] - times[key];
        double s = Math.min(Math.max((time - times[key]) / length, 0), 1);
        if (kind == Kind.CUBICSPLINE) {
            return unit(spline(key, s, length));
        }
        double[] a = unit(value(key, 0));
        double[] b = unit(value(next, 0));
        return isRotation ? Quaternions.slerp(a, b, s) : mixed(a, 1 - s, b, s);
    }

    /** Hermite's cubic of appendix C. */
    private double[] spline(int key, double s, double length) {
        double s2 = s * s;
        double s3 = s2 * s;
        double[] values = mixed(value(key, 1), 2 * s3 - 3 * s2 + 1, value(key + 1, 1), 3 * s2 - 2 * s3);
        double[] slopes = mixed(value(key, 2), length * (s3 - 2 * s2 + s), value(key + 1, 0), length * (s3 - s2));
        return mixed(values, 1, slopes, 1);
    }

    private double[] unit(double[] v) {
        return isRotation ? Quaternions.unit(v) : v;
    }

    private static double[] mixed(double[] a, double s, double[] b, double t) {
        double[] sum = new double[a.length];
        for (int i = 0; i < sum.length; i++) {
            sum[i] = a[i] * s + b[i] * t;
        }
        return sum;
    }

    /** @param part of a cubic key: 0 for the tangent before it, 1 for its value, 2 for the tangent after it; else 0 */
    private double[] value(int key, int part) {
        int components = isRotation ? 4 : 3;
        int at = (kind == Kind.CUBICSPLINE ? 3 * key + part : key) * components;
        double[] v = new double[components];
        for (int i = 0; i < components; i++) {
            v[i] = values[at + i];
        }
        return v;
    }
}
