package enlightenment.compiled;

import java.util.ArrayList;
import java.util.List;

/** The materials of primitives by id and face: a primitive has one for all its faces or one for each. Immutable. */
final class FaceMaterials {
    /** For each id, where its materials begin; one entry more than primitives. */
    private final int[] first;

    private final SurfaceMaterial[] materials;

    /** @param byId for each primitive its one material, or one per face */
    FaceMaterials(List<List<SurfaceMaterial>> byId) {
        first = new int[byId.size() + 1];
        List<SurfaceMaterial> all = new ArrayList<>(byId.size());
        for (int id = 0; id < byId.size(); id++) {
            first[id] = all.size();
            all.addAll(byId.get(id));
        }
        first[byId.size()] = all.size();
        materials = all.toArray(SurfaceMaterial[]::new);
    }

    /** The material of a face of a primitive. */
    SurfaceMaterial of(int id, int face) {
        int start = first[id];
        return materials[first[id + 1] - start == 1 ? start : start + face];
    }
}
