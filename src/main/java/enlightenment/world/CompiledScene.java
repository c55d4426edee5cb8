package enlightenment.world;

import enlightenment.accel.Accelerator;
import enlightenment.accel.ConeSearch;
import enlightenment.accel.PrimitiveList;
import enlightenment.color.DisplayCurve;
import enlightenment.frame.Bounds;
import enlightenment.frame.SceneFrame;
import enlightenment.material.Glass;
import enlightenment.primitive.Primitive;
import enlightenment.scene.Shading;
import enlightenment.world.camera.CompiledCamera;
import enlightenment.world.contact.CoincidentHits;
import enlightenment.world.contact.CoincidentSurfaces;
import enlightenment.world.contact.GlassBoxes;
import enlightenment.world.light.ClassicLight;
import enlightenment.world.light.LightImage;
import enlightenment.world.light.OccluderSet;
import enlightenment.world.material.FaceMaterials;
import enlightenment.world.material.SurfaceMaterial;
import enlightenment.world.parts.CompiledPrimitives;
import enlightenment.world.parts.RayCounters;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Predicate;
import java.util.function.Supplier;

/**
 * A scene made ready for rendering: only what it requires, in flat arrays. Immutable, shared by all threads.
 *
 * <p>Primitives are in a canonical order that does not depend on the order in the scene file, so that neither does the
 * picture.
 */
public final class CompiledScene {
    public final SceneFrame frame;
    public final CompiledCamera camera;

    /** The shading of the scene. */
    public final Shading shading;

    /** The shading, if it is classic; else null. */
    public final Shading.Classic classic;

    /** The lights and features of physical shading; null if the shading is classic. */
    public final PhysicalScene physical;

    public final ClassicLight[] lights;

    /** The visible lights of classic shading, and boxes around them. */
    public final ClassicLight[] visibleLights;

    public final Bounds[] lightBounds;

    /** The primitives by id. */
    public final Primitive[] primitives;

    /** Boxes around the primitives by id; empty if there is a hierarchy, which has its own. */
    final Bounds[] bounds;

    private final CompiledPrimitives compiled;
    private final FaceMaterials materials;

    /** Finds the first primitive that a ray hits: by a hierarchy, or by a list where a plain loop is faster. */
    public final Accelerator accelerator;

    /** Finds the primitives that may occlude a light. */
    public final OccluderSet occluders;

    /** By id: the kind of shape, an index into {@link #kindNames}. */
    public final int[] kind;

    /** The kinds of shapes in the scene. */
    public final List<String> kindNames;

    /** The largest number of surfaces that a line can cross. */
    public final int crossings;

    /** Ids of solids made of glass. */
    public final int[] glassSolids;

    /** Ids of those glass solids that a camera ray may start in. */
    public final int[] cameraSolids;

    /** The faces that coincide with others. */
    public final CoincidentSurfaces coincident;

    /** Whether a visible light lies on a face of a primitive. */
    final boolean lightsLieOnSurfaces;

    /** Boxes around the solids of glass, widened by more than roundings. */
    public final GlassBoxes glassBoxes;

    /** By id: rank of a glass solid, the smallest fills overlaps; see {@link Glass#priority}. */
    public final int[] mediumRank;

    /** By id: the index of its object in the scene's list, from 0. */
    public final int[] object;

    /** The number of objects in the scene's list, including duplicates of which only one became a primitive. */
    public final int objects;

    /** Images of lights on the film that the samples of a pixel may miss; empty unless shading is physical. */
    public final LightImage[] lightImages;

    /** The spherical mirrors whose images of lights can be sampled; null if there are none. */
    public final MirrorBalls mirrorBalls;

    /** The scene at the moments that its picture is the mean of; empty for a picture of a single moment. */
    public final CompiledScene[] instants;

    private ConeSearch coneSearch;
    private LightStarts lightStarts;
    private LightStarts lightStartsWithBackground;
    private final Map<Class<?>, Object> made = new HashMap<>();
    private final List<String> features;
    private final List<String> absent;

    /** The display curve of the scene's pictures. */
    public final DisplayCurve display;

    /** Takes the results of all passes. */
    CompiledScene(ScenePasses made, CompiledScene... instants) {
        this.instants = instants;
        frame = made.frame;
        camera = made.camera;
        shading = made.scene.shading();
        classic = shading instanceof Shading.Classic c ? c : null;
        display = shading instanceof Shading.Physical
                ? DisplayCurve.of(
                        made.scene.display().exposure(), made.scene.display().tone())
                : DisplayCurve.NONE;
        physical = made.physical;
        lights = made.lights;
        visibleLights =
                Arrays.stream(lights).filter(light -> light.surface != null).toArray(ClassicLight[]::new);
        lightBounds = Arrays.stream(visibleLights).map(ClassicLight::bounds).toArray(Bounds[]::new);
        compiled = made.compiled;
        primitives = compiled.primitives();
        materials = compiled.materials();
        kind = compiled.kind();
        kindNames = compiled.kindNames();
        crossings = (int) Math.min(
                Integer.MAX_VALUE,
                Arrays.stream(primitives).mapToLong(Primitive::crossings).sum());
        glassSolids = compiled.glassSolids();
        mediumRank = compiled.mediumRank();
        object = compiled.object();
        objects = compiled.objects();
        accelerator = made.accelerator;
        bounds = accelerator instanceof PrimitiveList
                ? Arrays.stream(primitives).map(Primitive::bounds).toArray(Bounds[]::new)
                : new Bounds[0];
        coincident = made.coincident;
        lightsLieOnSurfaces = made.lightsLieOnSurfaces;
        glassBoxes = made.glassBoxes;
        cameraSolids = made.cameraSolids;
        occluders = made.occluders;
        mirrorBalls = made.mirrorBalls;
        lightImages = made.lightImages;
        features = List.copyOf(made.features);
        absent = List.copyOf(made.absent);
    }

    /** The primitives with their materials. */
    CompiledPrimitives parts() {
        return compiled;
    }

    /** A search for the surfaces that coincide with a hit, for one thread. */
    public CoincidentHits coincidentHits() {
        return new CoincidentHits(compiled, coincident, physical != null);
    }

    /** Whether a face of a primitive is made of glass. */
    public boolean isGlass(int id, int face) {
        return material(id, face).isGlass;
    }

    /** The material that fills a solid of glass. */
    public SurfaceMaterial inside(int glassSolid) {
        return materials.inside(glassSolid);
    }

    /** The material of a face of a primitive. */
    public SurfaceMaterial material(int id, int face) {
        return materials.of(id, face);
    }

    /** The features that are modelled because the scene requires them, in plain words. */
    public List<String> features() {
        return features;
    }

    /** The features that are left out because the scene does not require them, in plain words. */
    public List<String> absent() {
        return absent;
    }

    /** The search that decides visibilities in the hierarchy. Made at the first call, as few renders need it. */
    synchronized ConeSearch coneSearch() {
        if (coneSearch == null) {
            coneSearch = ConeSearch.of(accelerator);
        }
        return coneSearch;
    }

    /**
     * The emission sampling of light paths. Made at the first call, as few renders need it.
     *
     * @param withBackground whether paths may begin in the surroundings
     */
    public synchronized LightStarts lightStarts(boolean withBackground) {
        if (withBackground) {
            if (lightStartsWithBackground == null) {
                lightStartsWithBackground = new LightStarts(physical, primitives, true);
            }
            return lightStartsWithBackground;
        }
        if (lightStarts == null) {
            lightStarts = new LightStarts(physical, primitives, false);
        }
        return lightStarts;
    }

    /**
     * An object that another package derives from the scene, made at the first call and shared by all threads.
     *
     * @param kind its class: one object of each is kept
     * @param maker makes it, immutable, from this scene alone
     */
    public synchronized <T> T once(Class<T> kind, Supplier<T> maker) {
        Object known = made.get(kind);
        if (known == null) {
            known = maker.get();
            made.put(kind, known);
        }
        return kind.cast(known);
    }

    /** The moments that the picture is the mean of: this scene alone where there are no {@link #instants}. */
    public CompiledScene[] moments() {
        return instants.length == 0 ? new CompiledScene[] {this} : instants.clone();
    }

    /** The counters for rays of a moment: those of this scene, unless the moment lacks kinds of shapes, as where a light goes out. */
    public RayCounters countersOf(CompiledScene moment, RayCounters counters) {
        return moment.kindNames.equals(kindNames) ? counters : new RayCounters(moment.kindNames.size());
    }

    /** Whether there is a caustic pass at any of the picture's moments. */
    public boolean hasCausticPass() {
        return isEver(moment -> moment.physical != null && moment.physical.hasCausticPass());
    }

    /** Whether a condition holds at any of the picture's moments. */
    public boolean isEver(Predicate<CompiledScene> isSo) {
        return Arrays.stream(moments()).anyMatch(isSo);
    }
}
