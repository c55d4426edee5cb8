package enlightenment.compiled;

import java.util.Arrays;

/** What one thread counted. Plain fields; added up in the order of threads when all is done. */
public final class RayCounters {
    public long cameraRays;
    public long mirrorRays;
    public long refractedRays;
    public long shadowRays;
    public long lightSamples;
    public long lightSamplesWithoutRay;
    public long textureLookups;

    /** Light points that ray clusters proposed, and those of them that were the kind they sought. */
    public long proposals;

    public long accepted;

    /** Ray clusters that proposed light points. */
    public long clusters;

    /** Tests by kind of primitive; {@link CompiledScene#kindNames} names them. */
    public final long[] tests;

    public final long[] hits;

    public RayCounters(int kinds) {
        tests = new long[kinds];
        hits = new long[kinds];
    }

    /** Forgets all that was counted. */
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

    /** Adds what another thread counted. */
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
