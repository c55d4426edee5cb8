package enlightenment.shading;

import enlightenment.compiled.CompiledScene;
import enlightenment.primitive.Ray;
import java.util.Arrays;

/**
 * The glass solids that a ray is inside of. Where several overlap, the one of smallest rank is the medium (Schmidt and
 * Budge, "Simple nested dielectrics in ray traced images", 2002).
 */
final class MediumStack {
    private final CompiledScene scene;
    private int[] ids = new int[4];
    private int size;

    MediumStack(CompiledScene scene) {
        this.scene = scene;
    }

    /** Copies another stack. */
    void set(MediumStack o) {
        if (ids.length < o.size) {
            ids = new int[o.ids.length];
        }
        System.arraycopy(o.ids, 0, ids, 0, o.size);
        size = o.size;
    }

    void clear() {
        size = 0;
    }

    int size() {
        return size;
    }

    int get(int k) {
        return ids[k];
    }

    boolean contains(int id) {
        for (int k = 0; k < size; k++) {
            if (ids[k] == id) {
                return true;
            }
        }
        return false;
    }

    void add(int id) {
        if (!contains(id)) {
            if (size == ids.length) {
                ids = Arrays.copyOf(ids, 2 * size);
            }
            ids[size++] = id;
        }
    }

    void remove(int id) {
        for (int k = 0; k < size; k++) {
            if (ids[k] == id) {
                ids[k] = ids[--size];
                return;
            }
        }
    }

    /** Enters a solid through its border, or leaves it. */
    void cross(int solid, int side) {
        if (side == Ray.OUTSIDE) {
            add(solid);
        } else {
            remove(solid);
        }
    }

    /** The solid that is the medium, or -1 in empty space. */
    int current() {
        int best = -1;
        for (int k = 0; k < size; k++) {
            if (best < 0 || scene.mediumRank[ids[k]] < scene.mediumRank[best]) {
                best = ids[k];
            }
        }
        return best;
    }

    /** The index of refraction of the medium; 1 in empty space. */
    double indexOfRefraction() {
        int id = current();
        return id < 0 ? 1 : scene.material(id, 0).indexOfRefraction;
    }
}
