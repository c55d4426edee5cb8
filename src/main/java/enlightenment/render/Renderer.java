package enlightenment.render;

import enlightenment.device.DeviceChoice;
import enlightenment.device.share.PreparedDevice;
import enlightenment.image.Image;
import enlightenment.image.ImageFiles;
import enlightenment.math.InvalidValueException;
import enlightenment.mesh.tree.TriangleTree;
import enlightenment.plan.Integrators;
import enlightenment.plan.MethodDecision;
import enlightenment.plan.MethodPilot;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.Method;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.SceneException;
import enlightenment.work.Cancellation;
import enlightenment.work.Phases;
import enlightenment.work.Stopwatch;
import enlightenment.world.CompiledScene;
import enlightenment.world.SceneCompiler;
import enlightenment.world.check.SceneHints;
import enlightenment.world.check.SceneProblems;
import enlightenment.world.light.SceneImages;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Executor;
import java.util.function.BooleanSupplier;

/**
 * Renders scenes: the way from a {@link Scene} to an {@link Image}.
 *
 * <p>The picture is a pure function of the scene and of those settings that say they influence it: the same bytes on any number of threads,
 * on any machine.
 *
 * <p><b>Threads.</b> All methods may be called by any number of threads at once, platform or virtual. A render uses the calling thread and,
 * with more than one thread in its settings, helpers of its own that end before it returns. {@code cancelled} is polled by all of them, by
 * several at once: between any two units of work (a tile, a pass over one, a batch of paths), now and then within one, and between the
 * phases. The listener is called from any of them, too, but by one at a time; while it runs, threads that finish a unit wait for it, so
 * that it should not block. {@code cancelled} may: a pause there pauses the thread that polls, between two pieces of its work, with the
 * same picture in the end. That is how a render leaves processors to others for a while. It should be short: it delays the end of a render
 * that is cancelled. What they throw ends the render, which throws it on.
 *
 * <p><b>Stopping.</b> Once {@code cancelled} is true, or the calling thread is interrupted, the units under way are given up and the render
 * returns with what it has: {@link RenderResult#complete} is false. While it is planned the result is empty, and no archive receives a
 * plan. While a large scene is still prepared there is nothing to return: then it ends by a {@link CancellationException}. An interrupt
 * stays set: a caller that writes the result to a file has to clear it first ({@link Thread#interrupted}), since channels to files do not
 * work on an interrupted thread. An interrupt of a helper has no effect.
 */
public final class Renderer {
    /** Measured for spheres with a hierarchy (docs/notes/benchmarks.md), rounded up. */
    private static final long BYTES_PER_PRIMITIVE = 400;

    private Renderer() {}

    /**
     * Renders the scene as it asks to be, on all processors.
     *
     * @throws SceneException if the scene cannot be used
     * @throws enlightenment.math.InvalidValueException if the picture does not fit into the memory
     * @throws CancellationException if the thread was interrupted before the picture was whole; the interrupt stays set
     */
    public static Image render(Scene scene) {
        return render(scene, RenderSettings.of(scene));
    }

    /**
     * Renders the scene.
     *
     * @throws SceneException if the scene cannot be used
     * @throws enlightenment.math.InvalidValueException if a setting cannot be used
     * @throws CancellationException if the thread was interrupted before the picture was whole; the interrupt stays set
     * @throws IllegalStateException if samples were infinite or no numbers, which is a fault of the program
     */
    public static Image render(Scene scene, RenderSettings settings) {
        RenderResult result = render(scene, settings, RenderProgress.NONE, () -> false);
        if (!result.complete()) {
            throw new CancellationException("the thread was interrupted before the picture was whole");
        }
        long lost = result.report().lostSamples();
        if (lost > 0) {
            throw new IllegalStateException(lost + " samples were infinite or no numbers: a fault of the program");
        }
        return result.image();
    }

    /**
     * Renders the scene, tells how it gets on, and can be stopped.
     *
     * @param progress called from several threads, one at a time
     * @param cancelled asked from several threads at once; once true, the render ends with what it has
     * @throws SceneException if the scene cannot be used
     * @throws enlightenment.math.InvalidValueException if a setting cannot be used
     */
    public static RenderResult render(
            Scene scene, RenderSettings settings, RenderProgress progress, BooleanSupplier cancelled) {
        return render(RenderRequest.of(scene)
                .withSettings(settings)
                .withProgress(progress)
                .withCancelled(cancelled));
    }

    /**
     * Renders what is requested.
     *
     * @throws SceneException if the scene cannot be used
     * @throws enlightenment.math.InvalidValueException if a setting cannot be used
     * @throws CancellationException if it was cancelled while a scene with several images or thousands of objects was prepared
     */
    public static RenderResult render(RenderRequest request) {
        return render(request, new SceneImages());
    }

    /**
     * Renders what is requested on a thread of an executor, and returns at once. That thread may be a virtual one; it is busy until the render
     * ends. With one thread in the settings the render uses that thread alone, as suits many renders side by side.
     *
     * <p>Cancelling the future, or completing it in any other way, ends the render within a unit of work, and keeps one that has not begun
     * from beginning; so does {@code cancelled} of the request, and an interrupt of the executor's thread: then {@link
     * RenderResult#complete} is false. The future fails with what {@link #render(RenderRequest)} throws.
     *
     * @throws java.util.concurrent.RejectedExecutionException if the executor takes no more work
     */
    public static CompletableFuture<RenderResult> submit(RenderRequest request, Executor executor) {
        return SubmittedRender.begin(request, executor);
    }

    /** {@link #render(RenderRequest)} with image files that are shared with other renders. */
    static RenderResult render(RenderRequest request, SceneImages files) {
        BooleanSupplier cancelled = Cancellation.of(request.cancelled());
        RenderRequest.MethodChoice choice =
                request.choice().orElseGet(() -> choose(request.scene(), request.settings(), files, cancelled));
        choice.reason().ifPresent(request.progress()::note);
        return render(request.withChoice(choice), choice, files, cancelled);
    }

    /**
     * Finds what is requested beside the colours of pixels, without their colours: what takes a ray per pixel, or the beginnings of paths.
     *
     * @param request with the number of samples in its budget, which albedo and direct light are the means of, 1 where it has none; of a
     *     choice the scene that it has prepared, if it has; archives and listener are not used
     * @return an image for each kind
     * @throws SceneException if the scene cannot be used
     * @throws enlightenment.math.InvalidValueException if a setting cannot be used; key {@code auxiliary} if a kind takes the picture, as
     *     {@link RenderResult.Auxiliary#ERROR}, {@link RenderResult.Auxiliary#SAMPLES} and {@link RenderResult.Auxiliary#INDIRECT} do, or is for other shading
     * @throws CancellationException if it was cancelled
     */
    public static Map<RenderResult.Auxiliary, Image> auxiliary(RenderRequest request) {
        RenderSettings settings = request.settings();
        for (RenderResult.Auxiliary kind : request.auxiliary()) {
            if (kind == RenderResult.Auxiliary.INDIRECT || !kind.needsRays() && !kind.needsPaths()) {
                throw new InvalidValueException("auxiliary", kind.word() + " is known of rendered pictures only");
            }
        }
        BooleanSupplier cancelled = Cancellation.of(request.cancelled());
        new FilmChoice(request, request.auxiliary().size()).check();
        CompiledScene scene = request.choice()
                .flatMap(RenderRequest.MethodChoice::compiled)
                .orElseGet(() -> SceneCompiler.compile(request.scene(), settings, new SceneImages(), cancelled));
        AuxiliaryPass rays = new AuxiliaryPass(scene, settings, request.auxiliary());
        PathPartPass paths = new PathPartPass(scene, settings, request.auxiliary());
        rays.run(cancelled);
        if (paths.isNeeded()) {
            paths.run(Math.max(settings.budget().samples().orElse(1), 1), cancelled);
        }
        if (cancelled.getAsBoolean()) {
            throw new CancellationException("what pixels show was cancelled");
        }
        Map<RenderResult.Auxiliary, Image> images = rays.images();
        paths.addTo(null, images);
        return images;
    }

    private static RenderResult render(
            RenderRequest request, RenderRequest.MethodChoice choice, SceneImages files, BooleanSupplier cancelled) {
        Stopwatch time = choice.time();
        RenderSettings settings = request.settings();
        int images = (request.progressive() ? 1 : 0)
                + request.neededAuxiliary().size()
                + (request.denoised() ? Denoising.IMAGES : 0)
                // The picture that was not exact enough is kept until there is a better one.
                + (settings.budget().error().isPresent() ? 1 : 0);
        FilmChoice film = new FilmChoice(request, images);
        film.check();
        Phases phases = choice.phases();
        CompiledScene scene = choice.compiled()
                .orElseGet(() -> phases.run(
                        "compile", () -> SceneCompiler.compile(request.scene(), settings, files, cancelled)));
        film.check(scene);
        if (request.denoised()) {
            Denoising.check(scene);
        }
        try (PreparedDevice device = device(request, scene)) {
            return new PreparedRender(request, scene, film, phases, time, device, cancelled).run();
        }
    }

    private static PreparedDevice device(RenderRequest request, CompiledScene scene) {
        boolean keepsSamples = request.archives().stream()
                .anyMatch(a -> a instanceof RenderResult.Archive.OfSamples samples && samples.keepsSamples());
        if (keepsSamples && DeviceChoice.of(request.device()).kind() == DeviceChoice.Kind.OPENCL) {
            throw new InvalidValueException("device", "cannot be " + request.device() + ": devices keep no samples");
        }
        return PreparedDevice.of(
                keepsSamples ? DeviceChoice.NONE : request.device(),
                scene,
                request.settings(),
                request.progress()::note);
    }

    /**
     * Chooses the method of a render, if its settings leave that to the program ({@link Method#AUTO}): a function of scene, size, seed and
     * budget, the same for every crop and on every machine. Takes about a hundredth of the render. The seconds of a budget are counted from
     * here on.
     *
     * @param cancelled asked from several threads at once
     * @throws SceneException if the scene cannot be used
     * @throws enlightenment.math.InvalidValueException if a setting cannot be used
     * @throws CancellationException if it was cancelled, or the calling thread interrupted, before the method was chosen
     */
    public static RenderRequest.MethodChoice choose(Scene scene, RenderSettings settings, BooleanSupplier cancelled) {
        return choose(scene, settings, new SceneImages(), Cancellation.of(cancelled));
    }

    /** {@link #choose} with the scene compiled in any case. */
    static RenderRequest.MethodChoice prepare(
            Scene scene, RenderSettings settings, SceneImages files, BooleanSupplier stop) {
        BooleanSupplier cancelled = Cancellation.of(stop);
        RenderRequest.MethodChoice choice = choose(scene, settings, files, cancelled);
        if (choice.compiled().isPresent()) {
            return choice;
        }
        Phases phases = choice.phases();
        CompiledScene compiled =
                phases.run("compile", () -> SceneCompiler.compile(scene, choice.settings(), files, cancelled));
        return new RenderRequest.MethodChoice(choice.settings(), choice.reason(), compiled, phases, choice.time());
    }

    private static RenderRequest.MethodChoice choose(
            Scene scene, RenderSettings settings, SceneImages files, BooleanSupplier cancelled) {
        Stopwatch time = Stopwatch.started();
        Phases phases = new Phases();
        if (settings.method() != Method.AUTO) {
            return new RenderRequest.MethodChoice(settings, Optional.empty(), null, phases, time);
        }
        CompiledScene compiled = phases.run("compile", () -> SceneCompiler.compile(scene, settings, files, cancelled));
        MethodDecision decision = phases.run("pilot", () -> MethodPilot.decide(scene, compiled, settings, cancelled));
        return new RenderRequest.MethodChoice(
                settings.withMethod(decision.method()), Optional.of(decision.reason()), compiled, phases, time);
    }

    /** The models, needs and limits of a render of this scene, in plain words, without rendering it. */
    public static Inspection inspect(Scene scene, RenderSettings asked) {
        RenderRequest.MethodChoice choice = choose(scene, asked, () -> false);
        RenderSettings settings = choice.settings();
        CompiledScene compiled = choice.compiled().orElseGet(() -> SceneCompiler.compile(scene, settings));
        int primitives = compiled.primitives.length;
        List<String> hints = new ArrayList<>(SceneHints.of(scene, compiled));
        Integrators.blindSpot(settings.method(), compiled).ifPresent(hints::add);
        hints.addAll(Integrators.limitations(compiled));
        for (String reason : Integrators.undersampled(settings.method(), compiled)) {
            hints.add("the error may be underestimated: " + reason);
        }
        // Methods from outside are not looked for here: a scene that names none does not pay for the search.
        Set<Method> known = new LinkedHashSet<>(BuiltInMethod.ALL);
        known.add(settings.method());
        List<Sight> methods = new ArrayList<>();
        for (Method method : known) {
            if (Method.supports(method, scene)) {
                methods.add(new Sight(
                        method,
                        Integrators.blindSpot(method, compiled),
                        Integrators.fewestSamples(method, scene.shading().model())));
            }
        }
        return new Inspection(
                compiled.features(),
                compiled.absent(),
                primitives,
                FilmChoice.memory(scene, settings, compiled) + primitives * BYTES_PER_PRIMITIVE + meshBytes(scene),
                List.copyOf(hints),
                List.copyOf(methods));
    }

    /** The memory of meshes, each counted once. */
    private static long meshBytes(Scene scene) {
        return scene.meshes().stream()
                .mapToLong(m -> m.bytes() + TriangleTree.bytesOf(m))
                .sum();
    }

    /**
     * Fails if the scene cannot be rendered, which it finds out without rendering: it reads all images and builds what a render needs.
     *
     * @throws SceneException with all that it has found
     */
    public static void check(Scene scene, RenderSettings settings) {
        SceneProblems.check(scene, settings, ImageFiles::read);
    }

    /** Whether a method can tell of its camera samples one by one, to a {@link RenderResult.Archive.OfSamples}. */
    public static boolean recordsSamples(Method method) {
        return Integrators.recordsSamples(method);
    }

    /** The memory that the picture of a scene needs while it is rendered, in bytes; more if there are caustics in it. */
    public static long memoryFor(Scene scene, RenderSettings settings) {
        return FilmChoice.memory(scene, settings, null);
    }

    /**
     * The result of {@link #inspect}.
     *
     * @param modelled the effects that the scene requires and that are modelled
     * @param notModelled the effects that are left out because the scene does not require them
     * @param primitives number of primitives in the compiled scene
     * @param expectedMemoryBytes estimate of the memory for the compiled scene and the picture
     * @param hints probable mistakes, such as a camera inside a solid, each with its place, and light transport that the method cannot
     *     sample; empty for a scene that makes sense
     * @param methods the methods that can render the scene, in the order of {@link Method#all}
     */
    public record Inspection(
            List<String> modelled,
            List<String> notModelled,
            int primitives,
            long expectedMemoryBytes,
            List<String> hints,
            List<Sight> methods) {}

    /**
     * A method that can render a scene: one of the program's own, or that of the settings.
     *
     * @param method the method
     * @param blindSpot what of the scene it cannot see, as a sentence without a full stop that begins with its name; empty if it sees
     *     everything. Of a method from outside the program that is not known, and nothing is said
     * @param fewestSamples the fewest samples per pixel that it makes pictures of its own with, at least 1; with fewer its pictures are
     *     those of {@link Method#standIn}
     */
    public record Sight(Method method, Optional<String> blindSpot, double fewestSamples) {}
}
