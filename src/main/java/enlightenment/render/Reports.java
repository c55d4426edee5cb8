package enlightenment.render;

import enlightenment.compiled.RayCounters;
import enlightenment.film.ErrorEstimate;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** Makes reports of what was counted. */
final class Reports {
    private Reports() {}

    static RenderReport of(
            RenderOutline outline,
            ErrorEstimate error,
            long cameraSamples,
            RayCounters all,
            List<RenderReport.Phase> phases,
            long pixels,
            long peakMemory) {
        Map<String, Long> rays = new LinkedHashMap<>();
        rays.put("camera", all.cameraRays);
        rays.put("mirror", all.mirrorRays);
        rays.put("refracted", all.refractedRays);
        rays.put("shadow", all.shadowRays);
        RenderReport.Sampling sampling = new RenderReport.Sampling(
                outline.plan().method(),
                outline.plan().decidedBy(),
                outline.plan().samples(),
                cameraSamples / (double) Math.max(pixels, 1),
                error.rmse(),
                error.low(),
                error.high(),
                all.clusters,
                all.proposals,
                all.accepted,
                0,
                1);
        return new RenderReport(
                outline.sceneName(),
                outline.settings(),
                outline.features(),
                rays,
                all.lightSamples,
                all.lightSamplesWithoutRay,
                sampling,
                byKind(outline, all.tests),
                byKind(outline, all.hits),
                all.textureLookups,
                List.copyOf(phases),
                pixels,
                peakMemory);
    }

    private static Map<String, Long> byKind(RenderOutline outline, long[] counts) {
        Map<String, Long> map = new LinkedHashMap<>();
        for (int k = 0; k < counts.length; k++) {
            map.put(outline.kinds().get(k), counts[k]);
        }
        return map;
    }
}
