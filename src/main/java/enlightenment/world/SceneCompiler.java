package enlightenment.world;

import enlightenment.frame.SceneFrame;
import enlightenment.geometry.Shape;
import enlightenment.light.Light;
import enlightenment.numeric.Scale;
import enlightenment.primitive.Primitive;
import enlightenment.primitive.Primitives;
import enlightenment.scene.Method;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.SceneException;
import enlightenment.scene.SceneObject;
import enlightenment.scene.Shading;
import enlightenment.world.light.CompiledSurroundings;
import enlightenment.world.light.GlowingObjects;
import enlightenment.world.light.SceneImages;
import enlightenment.world.parts.CompiledPrimitives;
import enlightenment.world.parts.SceneExtent;
import java.nio.file.Path;
import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;
import java.util.function.Function;

/** Compiles a scene: builds only what it requires. */
public final class SceneCompiler {
    /** Up to this number of primitives a plain loop is faster than a hierarchy (docs/notes/benchmarks.md). */
    public static final int LOOP_LIMIT = 24;

    /** Measured for spheres with a hierarchy (docs/notes/benchmarks.md), rounded up. */
    private static final long BYTES_PER_OBJECT = 400;

    /** The exponent of a unit of length in which no sum of numbers of a scene overflows. */
    private static final int OVERFLOW_EXPONENT = 8;

    /** A view may be at most this many powers of two wider than the scene, whose extent in its frame is about 1. */
    private static final int MAX_VIEW_EXPONENT = 64;

    private SceneCompiler() {}

    /** Compiles a scene for rendering at the size of the settings. */
    public static CompiledScene compile(Scene scene, RenderSettings settings) {
        return compile(scene, settings, new SceneImages());
    }

    /**
     * As {@link #compile(Scene, RenderSettings)}, with image files whose content is already in memory.
     *
     * @param files returns the content of an image file, or null if it must be read from the disk
     */
    public static CompiledScene compile(Scene scene, RenderSettings settings, Function<Path, byte[]> files) {
        return compile(scene, settings, new SceneImages(files));
    }

    /**
     * As {@link #compile(Scene, RenderSettings)}, with image files that earlier scenes may have needed too.
     *
     * @param images reads the image files, and keeps them
     */
    public static CompiledScene compile(Scene scene, RenderSettings settings, SceneImages images) {
        return compile(scene, settings, images, () -> false);
    }

    /**
     * As {@link #compile(Scene, RenderSettings, SceneImages)}, but can be cancelled.
     *
     * @param cancelled called by this thread between images and regularly in long loops
     * @throws CancellationException soon after that has become true, for scenes with several images or thousands of objects
     */
    public static CompiledScene compile(
            Scene scene, RenderSettings settings, SceneImages images, BooleanSupplier cancelled) {
        Runnable poll = () -> {
            if (cancelled.getAsBoolean()) {
                throw new CancellationException("stopped before anything was rendered");
            }
        };
        return compile(scene, settings, LOOP_LIMIT, images, Primitives::placeAll, poll);
    }

    /**
     * Throws where {@link #compile} would, textures of surfaces aside, without building more than that requires.
     *
     * @param images reads the picture of surroundings where that is needed
     */
    public static void check(Scene scene, SceneImages images) {
        checkObjects(scene, images);
        scene.instants().forEach(moment -> CompiledSurroundings.check(moment, images));
        CompiledSurroundings.check(scene, images);
    }

    /** Checks a scene except for surroundings, and for lights and textures that are in files. */
    public static void check(Scene scene) {
        checkObjects(scene, null);
    }

    private static void checkObjects(Scene scene, SceneImages images) {
        requireMemory(scene);
        scene.instants().forEach(moment -> checkMoment(moment, images));
        checkMoment(scene, images);
    }

    /** Classic shading can render every scene that can be described. */
    private static void checkMoment(Scene scene, SceneImages images) {
        if (scene.shading().model() == Shading.Model.PHYSICAL) {
            SceneFrame frame = frameOf(scene);
            Primitive[] primitives = new GlowingObjects(scene, frame, images)
                    .objects.stream()
                            .flatMap(o -> Primitives.placeAll(o.shape(), frame).stream())
                            .toArray(Primitive[]::new);
            SceneExtent.check(scene, frame, primitives);
        }
    }

    /** As {@link #compile(Scene, RenderSettings)}, with or without a hierarchy: the picture is the same. */
    public static CompiledScene compile(Scene scene, RenderSettings settings, boolean withBvh) {
        return compile(
                scene, settings, withBvh ? -1 : Integer.MAX_VALUE, new SceneImages(), Primitives::placeAll, () -> {});
    }

    /**
     * As {@link #compile(Scene, RenderSettings, SceneImages)}.
     *
     * @param loopLimit with more primitives or objects than this a hierarchy is built
     * @param placement turns shapes into primitives
     * @param poll called regularly; what it throws ends this
     */
    public static CompiledScene compile(
            Scene scene,
            RenderSettings settings,
            int loopLimit,
            SceneImages images,
            CompiledPrimitives.Placement placement,
            Runnable poll) {
        Method.requireSupport(settings.method(), scene);
        requireMemory(scene);
        CompiledScene[] instants = new CompiledScene[scene.instants().size()];
        for (int i = 0; i < instants.length; i++) {
            instants[i] = new ScenePasses(scene.instants().get(i), images, poll).run(settings, loopLimit, placement);
        }
        return new ScenePasses(scene, images, poll).run(settings, loopLimit, placement, instants);
    }

    private static void requireMemory(Scene scene) {
        long bytes =
                BYTES_PER_OBJECT * scene.instants().size() * scene.objects().size();
        if (bytes > Runtime.getRuntime().maxMemory()) {
            throw SceneException.of(
                    "/animation/instants",
                    scene.instants().size() + " instants of " + scene.objects().size() + " objects need about "
                            + (bytes >> 20) + " MiB of memory; there are "
                            + (Runtime.getRuntime().maxMemory() >> 20));
        }
    }

    /**
     * The frame whose origin is the eye and whose unit is the power of two that brings every coordinate below 2.
     */
    static SceneFrame frameOf(Scene scene) {
        double largest = extent(scene, new SceneFrame(scene.camera().origin(), 0));
        if (largest < Double.POSITIVE_INFINITY) {
            return frame(scene, largest, 0);
        }
        // Every number of a scene is a double, so their sums and differences are below 2^1027.
        return frame(
                scene, extent(scene, new SceneFrame(scene.camera().origin(), OVERFLOW_EXPONENT)), OVERFLOW_EXPONENT);
    }

    private static SceneFrame frame(Scene scene, double largest, int unit) {
        int exponent = largest == 0 ? 0 : Scale.exponent(largest) + unit;
        int reach = Scale.exponent(scene.camera().reach());
        // The height of a parallel view is no coordinate, but must be representable in the frame too.
        return new SceneFrame(scene.camera().origin(), Math.max(exponent, reach - MAX_VIEW_EXPONENT));
    }

    /** The largest absolute coordinate of the scene in a frame. */
    private static double extent(Scene scene, SceneFrame frame) {
        double largest = SceneExtent.of(scene.camera().anchors(), 0, frame);
        for (Light light : scene.lights()) {
            largest = Math.max(largest, SceneExtent.of(light.anchors(), light.reach(), frame));
        }
        for (SceneObject o : scene.objects()) {
            Shape s = o.shape();
            largest = Math.max(largest, SceneExtent.of(s.anchors(), s.reach(), frame));
        }
        return largest;
    }
}
