package enlightenment.device;

import enlightenment.mesh.TriangleMesh;
import enlightenment.mesh.tree.FlatMesh;
import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;

/** Writes the meshes of a scene, each once for all its instances. */
final class MeshWriter {
    private static final int NONE = -1;

    private final Map<TriangleMesh, Integer> numbers = new IdentityHashMap<>();
    private final List<TriangleMesh> meshes = new ArrayList<>();

    /** The number of a mesh, counted from 0 in the order in which they are asked for. */
    int number(TriangleMesh mesh) {
        return numbers.computeIfAbsent(mesh, m -> {
            meshes.add(m);
            return meshes.size() - 1;
        });
    }

    /** Writes all that were asked for; returns where their records begin. */
    int write(NumberList.Doubles doubles, NumberList.Ints ints, NumberList.Floats floats) {
        NumberList.Ints records = new NumberList.Ints();
        for (TriangleMesh mesh : meshes) {
            FlatMesh flat = FlatMesh.of(mesh);
            records.add(
                    place(floats, flat.floats()),
                    flat.doubles() == null ? NONE : doubles.add(flat.doubles()),
                    ints.add(flat.corners()),
                    place(floats, flat.normals()),
                    place(floats, flat.uv()),
                    doubles.add(flat.numbers()),
                    floats.add(flat.boxes()),
                    ints.add(flat.children()),
                    ints.add(flat.order()));
        }
        return ints.add(records.toArray());
    }

    private static int place(NumberList.Floats floats, float[] numbers) {
        return numbers == null ? NONE : floats.add(numbers);
    }
}
