package enlightenment.world;

import enlightenment.accel.Accelerator;
import enlightenment.accel.Bvh;
import enlightenment.accel.PrimitiveList;
import enlightenment.frame.Bounds;
import enlightenment.frame.SceneFrame;
import enlightenment.numeric.Scale;
import enlightenment.primitive.MeshPrimitive;
import enlightenment.primitive.Primitive;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.SceneObject;
import enlightenment.scene.Shading;
import enlightenment.surroundings.Surroundings;
import enlightenment.world.camera.CompiledCamera;
import enlightenment.world.camera.RayStarts;
import enlightenment.world.contact.CoincidentSurfaces;
import enlightenment.world.contact.GlassBoxes;
import enlightenment.world.contact.TouchedBoxes;
import enlightenment.world.light.ClassicLight;
import enlightenment.world.light.CompiledSurroundings;
import enlightenment.world.light.GlowingObjects;
import enlightenment.world.light.LightBody;
import enlightenment.world.light.LightImage;
import enlightenment.world.light.LightImages;
import enlightenment.world.light.OccluderSet;
import enlightenment.world.light.SceneImages;
import enlightenment.world.parts.CompiledPrimitives;
import enlightenment.world.parts.SceneExtent;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;

/**
 * The passes that compile a scene at one moment, in their order: each sets its parts from the parts before it, and nothing changes after
 * the last.
 */
final class ScenePasses {
    /** The number of primitives that a loop tests in the time of one ray-mesh test; has no influence on any result. */
    private static final int MESH_TESTS = 6;

    /** The margin by which boxes are widened, in units of the largest coordinate: more than the roundings of two surfaces together. */
    private static final double WIDENING = Scale.gamma(128);

    final Scene scene;
    final Runnable poll;
    private final SceneImages images;
    private final boolean isPhysical;

    SceneFrame frame;
    CompiledCamera camera;
    CompiledPrimitives compiled;

    /** Lights and objects of physical shading; null for classic shading. */
    private GlowingObjects glowing;

    /** Lights of classic shading; none for physical shading. */
    ClassicLight[] lights = {};

    private List<SceneObject> objects;
    Accelerator accelerator;
    private boolean isLoop;
    PhysicalScene physical;
    CoincidentSurfaces coincident;
    boolean lightsLieOnSurfaces;
    GlassBoxes glassBoxes;
    int[] cameraSolids;
    OccluderSet occluders;
    MirrorBalls mirrorBalls;
    LightImage[] lightImages = {};
    List<String> features;
    List<String> absent;

    /**
     * @param poll called regularly; what it throws ends this
     */
    ScenePasses(Scene scene, SceneImages images, Runnable poll) {
        this.scene = scene;
        this.images = images;
        this.poll = poll;
        isPhysical = scene.shading() instanceof Shading.Physical;
    }

    /**
     * Runs all passes.
     *
     * @param loopLimit with more primitives or objects than this a hierarchy is built
     * @param placement turns shapes into primitives
     * @param instants the moments that a picture of the scene is the mean of
     */
    CompiledScene run(
            RenderSettings settings, int loopLimit, CompiledPrimitives.Placement placement, CompiledScene... instants) {
        frame = SceneCompiler.frameOf(scene);
        CompiledCamera described = CompiledCamera.of(scene.camera(), frame, settings.width(), settings.height());
        camera = isPhysical ? described : described.withoutLens();
        CompiledMaterials materials = placePrimitives(placement);
        buildAccelerator(loopLimit);
        makeLights();
        findContacts();
        findGlass();
        findOccluders();
        findImages();
        describe(materials);
        return new CompiledScene(this, instants);
    }

    private CompiledMaterials placePrimitives(CompiledPrimitives.Placement placement) {
        CompiledMaterials materials = new CompiledMaterials(scene, isPhysical ? frame : null, images, poll);
        objects = scene.objects();
        if (isPhysical) {
            glowing = new GlowingObjects(scene, frame, images);
            materials.bySource.putAll(glowing.surfaces);
            objects = glowing.objects;
        }
        compiled = CompiledPrimitives.of(objects, frame, materials.bySource, placement, poll);
        if (isPhysical) {
            SceneExtent.check(scene, frame, compiled.primitives());
        }
        return materials;
    }

    private void buildAccelerator(int loopLimit) {
        Primitive[] primitives = compiled.primitives();
        long tests = Arrays.stream(primitives)
                .mapToLong(p -> p instanceof MeshPrimitive ? MESH_TESTS : 1)
                .sum();
        isLoop = Math.max(tests, objects.size()) <= loopLimit;
        accelerator = isLoop ? PrimitiveList.of(primitives, compiled.kind()) : Bvh.build(primitives, poll);
    }

    private void makeLights() {
        if (scene.shading() instanceof Shading.Physical shading) {
            Surroundings around = CompiledSurroundings.withDistantLights(
                    images.around(shading.background()), shading.background(), scene.lights());
            physical = new PhysicalScene(
                    shading, frame, around, compiled, accelerator, glowing.points, camera.startBounds(), poll);
        } else {
            lights = scene.lights().stream()
                    .map(light -> new ClassicLight(light, frame))
                    .toArray(ClassicLight[]::new);
        }
    }

    /** Finds the faces that coincide, and the faces that lights lie on. */
    private void findContacts() {
        coincident = CoincidentSurfaces.of(compiled, accelerator, poll);
        TouchedBoxes near = new TouchedBoxes(
                compiled.primitives(), compiled.kind(), compiled.kindNames().size(), accelerator);
        if (isPhysical) {
            physical.lieOn(compiled, near, coincident, isLoop, poll);
        }
        for (ClassicLight light : lights) {
            light.lieOn(near);
            lightsLieOnSurfaces |= light.surface != null && !light.lyingOn().isEmpty();
        }
    }

    /** Finds boxes around solids of glass, and the solids that camera rays may start in. */
    private void findGlass() {
        int[] solids = compiled.glassSolids();
        glassBoxes = new GlassBoxes(solids, this::widened);
        RayStarts starts = camera.rayStarts();
        cameraSolids =
                Arrays.stream(solids).filter(id -> starts.mayLieIn(widened(id))).toArray();
    }

    private Bounds widened(int id) {
        Bounds box = compiled.primitives()[id].bounds();
        return CoincidentSurfaces.widened(box, WIDENING * box.maxAbs());
    }

    private void findOccluders() {
        LightBody[] bodies = isPhysical ? physical.lights : lights;
        occluders = new OccluderSet(compiled.primitives(), bodies, isLoop);
        if (isPhysical && accelerator instanceof PrimitiveList all) {
            physical.findOccluders(compiled.primitives(), occluders, all);
        }
    }

    /** Finds images of lights: in mirror balls, and directly from the eye unless an ambient medium attenuates. */
    private void findImages() {
        if (isPhysical) {
            mirrorBalls = MirrorBalls.of(compiled, coincident, physical, poll);
        }
        if (isPhysical && physical.around == null) {
            double background = Math.max(physical.backgroundR, Math.max(physical.backgroundG, physical.backgroundB));
            lightImages = LightImages.of(camera, physical.lights, coincident, physical.surroundings, background, poll);
        }
    }

    /** Collects the features that are modelled, and those that are not. */
    private void describe(CompiledMaterials materials) {
        SceneFeatures some = new SceneFeatures(scene, !isLoop, materials.bySource.values());
        PhysicalFeatures more = isPhysical ? new PhysicalFeatures(physical, compiled.materials(), mirrorBalls) : null;
        features = more == null ? some.present() : joined(more.present, some.present());
        absent = more == null ? some.absent() : joined(more.absent, some.absent());
    }

    private static List<String> joined(List<String> some, List<String> more) {
        return Stream.concat(some.stream(), more.stream()).toList();
    }
}
