package enlightenment.importer.pbrt;

import enlightenment.math.Vec3;
import enlightenment.mesh.TriangleMesh;
import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;

/**
 * Loop's subdivision of triangles (C. Loop, "Smooth subdivision surfaces based on triangles", 1987) with the weights of H. Hoppe and others
 * ("Piecewise smooth surface reconstruction", 1994) at open edges. Vertices end on the limit surface.
 */
final class LoopSubdivision {
    private final Vec3[] points;
    private final int[] indices;

    /** By edge: its number, which is the new vertex on it. */
    private final Map<Long, Integer> edges = new HashMap<>();

    /** By edge: its two ends, then the one or two vertices across from it, −1 for none. */
    private int[] sides = new int[64];

    private boolean isManifold = true;

    private LoopSubdivision(Vec3[] points, int[] indices) {
        this.points = points;
        this.indices = indices;
        for (int t = 0; t < indices.length; t += 3) {
            for (int k = 0; k < 3; k++) {
                addEdge(indices[t + k], indices[t + (k + 1) % 3], indices[t + (k + 2) % 3]);
            }
        }
    }

    /**
     * The mesh after some steps; smooth.
     *
     * @return empty if more than two triangles share an edge
     */
    static Optional<TriangleMesh> of(Vec3[] points, int[] indices, int levels) {
        LoopSubdivision mesh = new LoopSubdivision(points, indices);
        for (int level = 0; level < levels; level++) {
            if (!mesh.isManifold) {
                return Optional.empty();
            }
            mesh = mesh.refined();
        }
        if (!mesh.isManifold) {
            return Optional.empty();
        }
        Vec3[] limit = mesh.weighted(true);
        double[] positions = new double[3 * limit.length];
        for (int i = 0; i < positions.length; i++) {
            positions[i] = limit[i / 3].component(i % 3);
        }
        return Optional.of(TriangleMesh.of(positions, mesh.indices).smooth());
    }

    private static long key(int a, int b) {
        return (long) Math.min(a, b) << 32 | Math.max(a, b);
    }

    private void addEdge(int a, int b, int across) {
        int count = edges.size();
        Integer known = edges.putIfAbsent(key(a, b), count);
        if (4 * count == sides.length) {
            sides = Arrays.copyOf(sides, 2 * sides.length);
        }
        int at = 4 * (known == null ? count : known);
        if (known == null) {
            sides[at] = a;
            sides[at + 1] = b;
            sides[at + 2] = across;
            sides[at + 3] = -1;
        } else if (sides[at + 3] < 0) {
            sides[at + 3] = across;
        } else {
            isManifold = false;
        }
        isManifold &= a != b;
    }

    private boolean isOpen(int edge) {
        return sides[4 * edge + 3] < 0;
    }

    private LoopSubdivision refined() {
        int old = points.length;
        Vec3[] next = Arrays.copyOf(weighted(false), old + edges.size());
        for (int e = 0; e < edges.size(); e++) {
            Vec3 ends = points[sides[4 * e]].plus(points[sides[4 * e + 1]]);
            next[old + e] = isOpen(e)
                    ? ends.times(1.0 / 2)
                    : ends.times(3.0 / 8)
                            .plus(points[sides[4 * e + 2]]
                                    .plus(points[sides[4 * e + 3]])
                                    .times(1.0 / 8));
        }
        int[] finer = new int[4 * indices.length];
        int n = 0;
        for (int t = 0; t < indices.length; t += 3) {
            int a = indices[t];
            int b = indices[t + 1];
            int c = indices[t + 2];
            int ab = old + edges.get(key(a, b));
            int bc = old + edges.get(key(b, c));
            int ca = old + edges.get(key(c, a));
            for (int v : new int[] {a, ab, ca, ab, b, bc, ca, bc, c, ab, bc, ca}) {
                finer[n++] = v;
            }
        }
        return new LoopSubdivision(next, finer);
    }

    /**
     * The old vertices in their new places.
     *
     * @param isLimit whether they go to the limit surface, else one step
     */
    private Vec3[] weighted(boolean isLimit) {
        Vec3[] around = new Vec3[points.length];
        Vec3[] border = new Vec3[points.length];
        int[] valence = new int[points.length];
        int[] open = new int[points.length];
        Arrays.fill(around, Vec3.ZERO);
        Arrays.fill(border, Vec3.ZERO);
        for (int e = 0; e < edges.size(); e++) {
            for (int k = 0; k < 2; k++) {
                int v = sides[4 * e + k];
                Vec3 other = points[sides[4 * e + 1 - k]];
                around[v] = around[v].plus(other);
                valence[v]++;
                if (isOpen(e)) {
                    border[v] = border[v].plus(other);
                    open[v]++;
                }
            }
        }
        Vec3[] moved = new Vec3[points.length];
        for (int v = 0; v < moved.length; v++) {
            moved[v] = open[v] > 0
                    ? onBorder(points[v], border[v], open[v], isLimit)
                    : inside(points[v], around[v], valence[v], isLimit);
        }
        return moved;
    }

    private static Vec3 onBorder(Vec3 at, Vec3 neighbours, int count, boolean isLimit) {
        double weight = isLimit ? 1.0 / 5 : 1.0 / 8;
        return count == 2 ? at.times(1 - 2 * weight).plus(neighbours.times(weight)) : at;
    }

    private static Vec3 inside(Vec3 at, Vec3 neighbours, int valence, boolean isLimit) {
        if (valence < 3) {
            return at;
        }
        double beta = valence == 3 ? 3.0 / 16 : 3.0 / (8 * valence);
        double weight = isLimit ? 1 / (valence + 3 / (8 * beta)) : beta;
        return at.times(1 - valence * weight).plus(neighbours.times(weight));
    }
}
