package enlightenment.compiled;

import enlightenment.accel.Bvh;
import enlightenment.geometry.Primitive;
import enlightenment.math.Bounds;
import enlightenment.math.SceneFrame;
import enlightenment.scene.ClassicShading;
import java.util.Arrays;
import java.util.List;

/**
 * A scene made ready for rendering: only what it requires, in flat arrays. Immutable, shared by all threads.
 *
 * <p>Primitives stand in a canonical order that does not depend on the order in the scene file, so that neither does the
 * picture.
 */
public final class CompiledScene {
    public final SceneFrame frame;
    public final CompiledCamera camera;
    public final ClassicShading shading;
    public final CompiledLight[] lights;

    /** Those lights that can be seen, and boxes around them. */
    final CompiledLight[] visibleLights;

    final Bounds[] lightBounds;

    /** The primitives by id. */
    public final Primitive[] primitives;

    /** Boxes around the primitives by id; empty where a hierarchy has them. */
    final Bounds[] bounds;

    /** For each id, where its faces' materials begin in {@link #materials}. */
    private final int[] firstMaterial;

    private final SurfaceMaterial[] materials;

    /** The hierarchy over the primitives, or null where a plain loop is faster. */
    public final Bvh bvh;

    /** What may stand before a light. */
    final OccluderSet occluders;

    /** By id: the kind of shape, an index into {@link #kindNames}. */
    public final int[] kind;

    /** The kinds of shapes that there are. */
    public final List<String> kindNames;

    /** Ids of solids made of glass. */
    public final int[] glassSolids;

    /** Ids of those glass solids that a camera ray may start in. */
    public final int[] cameraSolids;

    /** Which surfaces may coincide with one of glass; null where there is no glass. */
    private final Neighbours neighbours;

    /** By id: rank of a glass solid in overlaps, the smallest fills them; see {@link enlightenment.material.Material.Glass}. */
    public final int[] mediumRank;

    /** By id: the place of its object in the scene's list, counted from 0. */
    public final int[] object;

    /** How many objects the scene's list has, those included that are hidden by twins in the same place. */
    public final int objects;

    private final List<String> features;
    private final List<String> absent;

    CompiledScene(
            SceneFrame frame,
            CompiledCamera camera,
            ClassicShading shading,
            CompiledLight[] lights,
            CompiledPrimitives compiled,
            Bvh bvh,
            List<String> features,
            List<String> absent) {
        this.frame = frame;
        this.camera = camera;
        this.shading = shading;
        this.lights = lights;
        this.primitives = compiled.primitives();
        this.firstMaterial = compiled.firstMaterial();
        this.materials = compiled.materials();
        this.kind = compiled.kind();
        this.kindNames = compiled.kindNames();
        this.glassSolids = compiled.glassSolids();
        this.mediumRank = compiled.mediumRank();
        object = compiled.object();
        objects = compiled.objects();
        this.bvh = bvh;
        CompiledLight[] visible = new CompiledLight[lights.length];
        int seen = 0;
        for (CompiledLight light : lights) {
            if (light.surface != null) {
                visible[seen++] = light;
            }
        }
        visibleLights = Arrays.copyOf(visible, seen);
        lightBounds = new Bounds[seen];
        for (int i = 0; i < seen; i++) {
            lightBounds[i] = visibleLights[i].bounds();
        }
        bounds = new Bounds[bvh == null ? primitives.length : 0];
        for (int id = 0; id < bounds.length; id++) {
            bounds[id] = primitives[id].bounds();
        }
        neighbours = Neighbours.of(this);
        Bounds start = camera.startBounds();
        int[] solids = new int[glassSolids.length];
        int n = 0;
        for (int id : glassSolids) {
            if (neighbours.bounds(id).overlaps(start)) {
                solids[n++] = id;
            }
        }
        cameraSolids = Arrays.copyOf(solids, n);
        occluders = new OccluderSet(primitives, lights, bvh);
        this.features = List.copyOf(features);
        this.absent = List.copyOf(absent);
    }

    /** A box around a primitive of glass, or one that touches glass. */
    public Bounds boundsOf(int id) {
        return neighbours.bounds(id);
    }

    /**
     * The primitives of which a part of the surface may be a part of this one's surface: for one of glass any other, for
     * one that is not of glass those of glass.
     */
    public int[] neighboursOf(int id) {
        return neighbours == null ? Neighbours.NONE : neighbours.of(id);
    }

    /** Whether any face of the primitive is glass. */
    public boolean isGlass(int id) {
        for (int k = firstMaterial[id]; k < firstMaterial[id + 1]; k++) {
            if (materials[k].kind == SurfaceMaterial.Kind.GLASS) {
                return true;
            }
        }
        return false;
    }

    /** The material of a face of a primitive. */
    public SurfaceMaterial material(int id, int face) {
        int first = firstMaterial[id];
        return materials[firstMaterial[id + 1] - first == 1 ? first : first + face];
    }

    /** What the scene requires and is modelled, in plain words. */
    public List<String> features() {
        return features;
    }

    /** What is left out because the scene does not require it, in plain words. */
    public List<String> absent() {
        return absent;
    }
}
