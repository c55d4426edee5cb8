package enlightenment.world.parts;

import java.util.Arrays;

/** What one thread counted: plain fields, summed over the threads at the end. */
public final class RayCounters {
    /** Camera rays shaded. */
    public long cameraRays;

    /** Rays reflected by mirrors, and totally in glass. */
    public long mirrorRays;

    /** Rays refracted. */
    public long refractedRays;

    /** Shadow rays traced. */
    public long shadowRays;

    /** Light samples taken. */
    public long lightSamples;

    /** Light samples whose visibility was known without a shadow ray. */
    public long lightSamplesWithoutRay;

    /** Lookups of image textures. */
    public long textureLookups;

    /** Light samples proposed by ray clusters, or proposals of Markov chains. */
    public long proposals;

    /** Proposals accepted: those with the visibility that the cluster sought, or accepted steps of chains. */
    public long accepted;

    /** Ray clusters that proposed light samples, or Markov chains. */
    public long clusters;

    /** Tests by kind of primitive; {@code CompiledScene} names them. */
    public final long[] tests;

    /** Hits by kind of primitive. */
    public final long[] hits;

    /** Counters at 0, for this number of kinds of primitives. */
    public RayCounters(int kinds) {
        tests = new long[kinds];
        hits = new long[kinds];
    }

    /** Sets all counters to 0. */
    public void clear() {
        cameraRays = 0;
        mirrorRays = 0;
        refractedRays = 0;
        shadowRays = 0;
        lightSamples = 0;
        lightSamplesWithoutRay = 0;
        textureLookups = 0;
        proposals = 0;
        accepted = 0;
        clusters = 0;
        Arrays.fill(tests, 0);
        Arrays.fill(hits, 0);
    }

    /** Adds the counters of another thread. */
    public void add(RayCounters o) {
        cameraRays += o.cameraRays;
        mirrorRays += o.mirrorRays;
        refractedRays += o.refractedRays;
        shadowRays += o.shadowRays;
        lightSamples += o.lightSamples;
        lightSamplesWithoutRay += o.lightSamplesWithoutRay;
        textureLookups += o.textureLookups;
        proposals += o.proposals;
        accepted += o.accepted;
        clusters += o.clusters;
        for (int i = 0; i < tests.length; i++) {
            tests[i] += o.tests[i];
            hits[i] += o.hits[i];
        }
    }
}
