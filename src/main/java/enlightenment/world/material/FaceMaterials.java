package enlightenment.world.material;

import java.util.Arrays;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.function.IntFunction;
import java.util.function.Predicate;

/** The materials of primitives by id and face: a primitive has one for all its faces or one for each. Immutable. */
public final class FaceMaterials {
    /** By id, the index of its first material, then the end of the last one's; null if each primitive has one. */
    private final int[] first;

    private final SurfaceMaterial[] materials;

    /** Each material once: a million primitives have few. */
    private final SurfaceMaterial[] distinct;

    /** @param byId for each of n primitives its one material, or one per face */
    public FaceMaterials(int n, IntFunction<List<SurfaceMaterial>> byId) {
        int[] starts = new int[n + 1];
        SurfaceMaterial[] all = new SurfaceMaterial[n];
        for (int id = 0; id < n; id++) {
            int end = starts[id];
            for (SurfaceMaterial m : byId.apply(id)) {
                all = end < all.length ? all : Arrays.copyOf(all, 2 * end + 1);
                all[end++] = m;
            }
            starts[id + 1] = end;
        }
        first = starts[n] == n ? null : starts;
        materials = Arrays.copyOf(all, starts[n]);
        distinct = distinct(materials);
    }

    private static SurfaceMaterial[] distinct(SurfaceMaterial[] all) {
        Set<SurfaceMaterial> found = new LinkedHashSet<>();
        SurfaceMaterial last = null;
        for (SurfaceMaterial m : all) {
            if (m != last) {
                found.add(m);
                last = m;
            }
        }
        return found.toArray(SurfaceMaterial[]::new);
    }

    /** Each of the materials once; in place of one with detail, the materials that it may resolve to. */
    public List<SurfaceMaterial> distinct() {
        Set<SurfaceMaterial> all = new LinkedHashSet<>();
        for (SurfaceMaterial m : distinct) {
            m.addTo(all);
        }
        return List.copyOf(all);
    }

    /** Whether some surface has an alpha mask. */
    public boolean haveMasks() {
        return Arrays.stream(distinct).anyMatch(SurfaceMaterial::hasMask);
    }

    /** Whether some surface depends on an image. */
    public boolean readImages() {
        return Arrays.stream(distinct).anyMatch(SurfaceMaterial::readsImages);
    }

    /** Whether some surface's material satisfies a condition. */
    public boolean any(Predicate<SurfaceMaterial> such) {
        // A loop, which needs less of the just-in-time compiler than a stream: thousands of lights are thousands of
        // materials.
        for (SurfaceMaterial m : distinct) {
            if (m.any(such)) {
                return true;
            }
        }
        return false;
    }

    /** The material that fills a solid of glass: that of the first of its faces of glass; if there is none, of face 0. */
    public SurfaceMaterial inside(int id) {
        int start = first == null ? id : first[id];
        int end = first == null ? id + 1 : first[id + 1];
        for (int k = start; k < end; k++) {
            if (materials[k].isGlass) {
                return materials[k];
            }
        }
        return materials[start];
    }

    /** The material of a face of a primitive. */
    public SurfaceMaterial of(int id, int face) {
        if (first == null) {
            return materials[id];
        }
        int start = first[id];
        return materials[first[id + 1] - start == 1 ? start : start + face];
    }
}
