package enlightenment.plan;

import enlightenment.scene.BuiltInMethod;
import enlightenment.world.parts.RayCounters;
import java.util.Arrays;

/**
 * What pictures cost, in nanoseconds of one processor, by what was counted: a function of scene and settings, unlike measured times. Only
 * ratios between methods matter. The factors are fitted to processor times of small scenes; {@code src/bench/scripts/auto.py costs} prints
 * how far they are off.
 */
final class PilotCosts {
    /** A shadow ray, and a test of a primitive. */
    private static final double SHADOW_RAY = 200;

    private static final double TEST = 6;

    private PilotCosts() {}

    /** Nanoseconds of what was traced by a method. */
    static double of(BuiltInMethod method, RayCounters counts) {
        return ofSample(method) * counts.cameraRays
                + ofHit(method) * Arrays.stream(counts.hits).sum()
                + SHADOW_RAY * counts.shadowRays
                + TEST * Arrays.stream(counts.tests).sum();
    }

    /** A camera sample, with the light paths that belong to it. */
    private static double ofSample(BuiltInMethod method) {
        return switch (method) {
            case RAYTRACE, CLUSTER, METROPOLIS -> 500;
            case LIGHT -> 300;
            case BIDIRECTIONAL, BIDIRECTIONAL_CLUSTER -> 1500;
        };
    }

    /** A surface that a path meets, with what is sampled there. */
    private static double ofHit(BuiltInMethod method) {
        return switch (method) {
            case RAYTRACE -> 1500;
            case CLUSTER, BIDIRECTIONAL_CLUSTER -> 1200;
            case LIGHT -> 900;
            case BIDIRECTIONAL -> 1650;
            case METROPOLIS -> 2000;
        };
    }
}
