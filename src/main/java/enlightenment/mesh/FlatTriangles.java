package enlightenment.mesh;

import enlightenment.mesh.data.VertexArrays;

/** The triangles among others whose three corners lie in one line, as far as doubles can tell. */
final class FlatTriangles {
    private final int[] all;

    /** Their numbers, in ascending order. */
    private final int[] flat;

    /** @param indices three vertices of each triangle, all of them there */
    FlatTriangles(VertexArrays vertices, int[] indices) {
        all = indices;
        double[] n = new double[3];
        Ints some = new Ints(0);
        for (int i = 0; i < all.length; i += 3) {
            if (!vertices.normal(all[i], all[i + 1], all[i + 2], n)) {
                some.add(i / 3);
            }
        }
        flat = some.toArray();
    }

    /** Three vertices of each of them. */
    int[] corners() {
        int[] some = new int[3 * flat.length];
        for (int i = 0; i < some.length; i++) {
            some[i] = all[3 * flat[i / 3] + i % 3];
        }
        return some;
    }

    /** Three vertices of each triangle that is none of them: the array that was given where there are none. */
    int[] cornersOfOthers() {
        if (flat.length == 0) {
            return all;
        }
        int[] some = new int[all.length - 3 * flat.length];
        int to = 0;
        for (int i = 0; i <= flat.length; i++) {
            int from = i == 0 ? 0 : 3 * flat[i - 1] + 3;
            int end = i == flat.length ? all.length : 3 * flat[i];
            System.arraycopy(all, from, some, to, end - from);
            to += end - from;
        }
        return some;
    }
}
