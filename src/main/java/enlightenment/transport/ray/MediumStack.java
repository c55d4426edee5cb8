package enlightenment.transport.ray;

import enlightenment.primitive.Ray;
import enlightenment.transport.state.PathWavelength;
import enlightenment.world.CompiledScene;
import enlightenment.world.material.SurfaceMaterial;
import java.util.Arrays;

/**
 * The solids of glass that a ray is inside of. Of several that overlap, the one with the smallest rank is the medium (Schmidt and Budge,
 * "Simple nested dielectrics in ray traced images", 2002).
 */
final class MediumStack {
    private final CompiledScene scene;
    private int[] ids = new int[4];
    private int size;

    /** The path's wavelength, which indices of refraction depend on; null if no glass of the scene disperses. */
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

    /**
     * Crosses the surface of a solid.
     *
     * @param side that the ray comes from: it enters the solid from outside and leaves it from inside
     */
    void cross(int solid, int side) {
        if (side == Ray.OUTSIDE) {
            add(solid);
        } else {
            remove(solid);
        }
    }

    /** The id of the solid that is the medium; -1 in empty space. */
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

    /** The index of refraction of the medium over that of a thin slab in it, both as the scene states them: thin slabs do not disperse. */
    double over(SurfaceMaterial pane) {
        SurfaceMaterial material = material();
        return (material == null ? 1 : material.indexOfRefraction) / pane.indexOfRefraction;
    }

    /** The index of refraction of the medium before an interface; reports the medium to the path's wavelength. */
    double leave() {
        if (wavelength != null) {
            wavelength.leave(material());
        }
        return indexOfRefraction();
    }

    /** The index of refraction of the medium behind the interface; reports the medium to the path's wavelength. */
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
