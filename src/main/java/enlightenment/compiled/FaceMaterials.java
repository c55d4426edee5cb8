package enlightenment.compiled;

import java.util.Arrays;
import java.util.List;
import java.util.function.IntFunction;

/** The materials of primitives by id and face: a primitive has one for all its faces or one for each. Immutable. */
final class FaceMaterials {
    /** For each id, where its materials begin; one entry more than primitives. */
    private final int[] first;

    private final SurfaceMaterial[] materials;

    /** @param byId for each of n primitives its one material, or one per face */
    FaceMaterials(int n, IntFunction<List<SurfaceMaterial>> byId) {
        first = new int[n + 1];
        SurfaceMaterial[] all = new SurfaceMaterial[n];
        for (int id = 0; id < n; id++) {
            int end = first[id];
            for (SurfaceMaterial m : byId.apply(id)) {
                all = end < all.length ? all : Arrays.copyOf(all, 2 * end + 1);
                all[end++] = m;
            }
            first[id + 1] = end;
        }
        materials = first[n] == all.length ? all : Arrays.copyOf(all, first[n]);
    }

    /** The material of a face of a primitive. */
    SurfaceMaterial of(int id, int face) {
        int start = first[id];
        return materials[first[id + 1] - start == 1 ? start : start + face];
    }
}
