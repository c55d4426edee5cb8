package enlightenment.mesh.tree;

import enlightenment.mesh.TriangleMesh;
import enlightenment.mesh.data.MeshData;
import java.util.List;
import java.util.function.Supplier;

/**
 * A mesh that was made of several, kept with the first of them until others are asked for: the frames of a film ask for the same.
 *
 * @param others all but the first one
 * @param placings how they are placed
 * @param all the triangles of the first one, then theirs
 */
record Union(List<TriangleMesh> others, List<?> placings, TriangleMesh all) {
    /** The mesh of these: the one that is kept if it was made of the same, else a new one, which is kept. */
    static TriangleMesh of(List<TriangleMesh> meshes, List<?> placings, Supplier<TriangleMesh> making) {
        MeshData first = meshes.get(0).data();
        List<TriangleMesh> others = meshes.subList(1, meshes.size());
        synchronized (first) {
            if (first.union() instanceof Union kept && kept.isOf(others, placings)) {
                return kept.all;
            }
            Union made = new Union(List.copyOf(others), List.copyOf(placings), making.get());
            first.keepUnion(made);
            return made.all;
        }
    }

    private boolean isOf(List<TriangleMesh> meshes, List<?> places) {
        boolean same = meshes.size() == others.size() && placings.equals(places);
        for (int i = 0; same && i < others.size(); i++) {
            same = meshes.get(i) == others.get(i);
        }
        return same;
    }
}
