package enlightenment.mesh;

import enlightenment.math.Vec3;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** Closes the holes of a mesh by fans of triangles over their rims. */
final class Holes {
    private final TriangleMesh mesh;

    /** The vertices around each hole, in the direction in which triangles that close it run. */
    private final List<int[]> rims = new ArrayList<>();

    private Holes(TriangleMesh mesh) {
        this.mesh = mesh;
    }

    /**
     * The mesh with its holes closed; empty if they are larger than a share of its area, if rims touch or cross, or if there are none.
     *
     * @param share of the area, 0..1
     */
    static Optional<TriangleMesh> closed(TriangleMesh mesh, OpenEdges open, double share) {
        Holes holes = new Holes(mesh);
        if (open.from.length == 0 || !holes.findRims(open) || holes.area() > share * holes.areaOfMesh()) {
            return Optional.empty();
        }
        return Optional.of(holes.closed()).filter(TriangleMesh::isClosed);
    }

    /** Whether each vertex of a rim is left by one edge only, so that they are closed and apart. */
    private boolean findRims(OpenEdges open) {
        Map<Integer, Integer> next = new LinkedHashMap<>();
        for (int i = 0; i < open.from.length; i++) {
            if (next.put(open.to[i], open.from[i]) != null) {
                return false;
            }
        }
        while (!next.isEmpty()) {
            List<Integer> rim = new ArrayList<>();
            Integer v = next.keySet().iterator().next();
            while (next.containsKey(v)) {
                rim.add(v);
                v = next.remove(v);
            }
            if (!v.equals(rim.get(0))) {
                return false;
            }
            rims.add(rim.stream().mapToInt(Integer::intValue).toArray());
        }
        return true;
    }

    private double areaOfMesh() {
        double sum = 0;
        for (int t = 0; t < mesh.triangles(); t++) {
            sum += mesh.areaNormal(t).length();
        }
        return sum;
    }

    /** Twice the area of what closes the holes. */
    private double area() {
        double sum = 0;
        for (int[] rim : rims) {
            for (int k = 1; k + 1 < rim.length; k++) {
                sum += normal(rim, k).length();
            }
        }
        return sum;
    }

    private Vec3 normal(int[] rim, int k) {
        Vec3 first = mesh.position(rim[0]);
        return mesh.position(rim[k])
                .minus(first)
                .cross(mesh.position(rim[k + 1]).minus(first));
    }

    private TriangleMesh closed() {
        int[] sources = sources();
        float[] normals = mesh.hasNormals() ? normals(sources.length) : null;
        return new TriangleMesh(mesh.data().vertices.copies(sources, normals), indices());
    }

    /** By vertex, the vertex of the mesh that it is made of: all of these, and those of the rims once more. */
    private int[] sources() {
        int[] all = new int
                [mesh.vertices() + rims.stream().mapToInt(rim -> rim.length).sum()];
        Arrays.setAll(all, v -> v);
        int end = mesh.vertices();
        for (int[] rim : rims) {
            System.arraycopy(rim, 0, all, end, rim.length);
            end += rim.length;
        }
        return all;
    }

    private int[] indices() {
        int[] kept = mesh.data().indices;
        int[] flat = mesh.data().withoutArea;
        Ints all = new Ints(kept.length + flat.length);
        Arrays.stream(kept).forEach(all::add);
        Arrays.stream(flat).forEach(all::add);
        int first = mesh.vertices();
        for (int[] rim : rims) {
            for (int k = 1; k + 1 < rim.length; k++) {
                all.add(first);
                all.add(first + k);
                all.add(first + k + 1);
            }
            first += rim.length;
        }
        return all.toArray();
    }

    /** Those of the mesh; a fan has its own, so that its rim is an edge. */
    private float[] normals(int vertices) {
        float[] normals = Arrays.copyOf(mesh.data().vertices.normals, 3 * vertices);
        int v = mesh.vertices();
        for (int[] rim : rims) {
            Vec3 sum = new Vec3(0, 0, 0);
            for (int k = 1; k + 1 < rim.length; k++) {
                sum = sum.plus(normal(rim, k));
            }
            Vec3 unit = sum.maxAbs() > 0 ? sum.normalized() : sum;
            for (int k = 0; k < rim.length; k++) {
                normals[3 * v] = (float) unit.x();
                normals[3 * v + 1] = (float) unit.y();
                normals[3 * v++ + 2] = (float) unit.z();
            }
        }
        return normals;
    }
}
