package enlightenment.work;

import enlightenment.world.parts.RayCounters;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** Counters by the names that reports give them. */
public final class RayCounts {
    private RayCounts() {}

    /** Number of rays by kind: camera, mirror, refracted, shadow. */
    public static Map<String, Long> raysByKind(RayCounters counters) {
        Map<String, Long> rays = new LinkedHashMap<>();
        rays.put("camera", counters.cameraRays);
        rays.put("mirror", counters.mirrorRays);
        rays.put("refracted", counters.refractedRays);
        rays.put("shadow", counters.shadowRays);
        return rays;
    }

    /** What was counted for each kind of primitive, in the order of the counters. */
    public static Map<String, Long> byPrimitive(List<String> kinds, long[] counts) {
        Map<String, Long> map = new LinkedHashMap<>();
        for (int k = 0; k < counts.length; k++) {
            map.put(kinds.get(k), counts[k]);
        }
        return map;
    }
}
