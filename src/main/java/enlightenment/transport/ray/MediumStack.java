package enlightenment.transport.ray;

import enlightenment.primitive.Ray;
import enlightenment.transport.state.PathWavelength;
import enlightenment.world.CompiledScene;
import enlightenment.world.material.SurfaceMaterial;
import java.util.Arrays;

/**
 * The glass solids that a ray is inside of. Where several overlap, the one of smallest rank is the medium (Schmidt and
 * Budge, "Simple nested dielectrics in ray traced images", 2002).
 */
final class MediumStack {
    private final CompiledScene scene;
    private int[] ids = new int[4];
    private int size;

    /** What indices of refraction depend on; null if there is no such thing. */
    private final PathWavelength wavelength;

    MediumStack(CompiledScene scene, PathWavelength wavelength) {
        this.scene = scene;
        this.wavelength = wavelength;
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
        SurfaceMaterial material = material();
        if (material == null) {
            return 1;
        }
        return wavelength == null ? material.indexOfRefraction : wavelength.index(material);
    }

    /** The index of refraction of the medium over that of a pane in it, both as the scene states them: panes do not disperse. */
    double over(SurfaceMaterial pane) {
        SurfaceMaterial material = material();
        return (material == null ? 1 : material.indexOfRefraction) / pane.indexOfRefraction;
    }

    /** The same before a border, of which the wavelength is told. */
    double leave() {
        if (wavelength != null) {
            wavelength.leave(material());
        }
        return indexOfRefraction();
    }

    /** The same behind it. */
    double enter() {
        if (wavelength != null) {
            wavelength.enter(material());
        }
        return indexOfRefraction();
    }

    /** The material of the medium; null in empty space. */
    private SurfaceMaterial material() {
        int id = current();
        return id < 0 ? null : scene.inside(id);
    }
}
