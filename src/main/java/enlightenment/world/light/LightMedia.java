package enlightenment.world.light;

import enlightenment.accel.Accelerator;
import enlightenment.accel.BvhQuery;
import enlightenment.frame.Bounds;
import enlightenment.world.parts.CancellationCheck;
import enlightenment.world.parts.CompiledPrimitives;
import java.util.Arrays;
import java.util.BitSet;

/** Finds the solids of glass that points of lights may lie in: those whose boxes overlap the light's. */
public final class LightMedia {
    private LightMedia() {}

    /**
     * Stores in each light the solids that its points may lie in.
     *
     * @param accelerator of all primitives
     * @param poll called regularly; what it throws ends this
     */
    public static void find(
            PhysicalLight[] lights, CompiledPrimitives compiled, Accelerator accelerator, Runnable poll) {
        if (compiled.glassSolids().length == 0) {
            return;
        }
        BitSet isGlass = new BitSet();
        for (int id : compiled.glassSolids()) {
            isGlass.set(id);
        }
        CancellationCheck work = new CancellationCheck(poll);
        BvhQuery query =
                new BvhQuery(compiled.kind(), new long[compiled.kindNames().size()]);
        int[] found = new int[1];
        for (PhysicalLight light : lights) {
            Bounds own = light.bounds();
            query.clear();
            accelerator.overlapping(own, query);
            work.steps(query.size() + 1);
            int n = 0;
            for (int k = 0; k < query.size(); k++) {
                int id = query.get(k);
                if (isGlass.get(id) && compiled.primitives()[id].bounds().overlaps(own)) {
                    found = n < found.length ? found : Arrays.copyOf(found, 2 * n);
                    found[n++] = id;
                }
            }
            if (n > 0) {
                light.media = Arrays.copyOf(found, n);
                Arrays.sort(light.media);
            }
        }
    }
}
