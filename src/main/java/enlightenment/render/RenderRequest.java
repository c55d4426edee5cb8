package enlightenment.render;

import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.work.Phases;
import enlightenment.work.Stopwatch;
import enlightenment.world.CompiledScene;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Collections;
import java.util.EnumSet;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;

/**
 * A request to render: a scene, its settings, a listener, and further outputs. Begin with {@link #of(Scene)} and change what should differ.
 * Only scene and settings have an influence on the picture.
 *
 * @param scene the scene to render
 * @param settings the method, its settings, the size and the budget
 * @param progress the listener: called from several threads, one at a time
 * @param cancelled polled by several threads at once; once true, the render ends with the finished part. An interrupt of the calling thread
 *     does likewise
 * @param auxiliary the images to make beside the picture
 * @param progressive whether coarse passes over the whole picture come first, so that from then on there is always a whole
 *     picture to show; they take about a seventh more time. A method whose paths may end anywhere needs none
 * @param watched whether somebody may look at the picture while it is rendered: coarse passes over the whole of it come first, for at most a
 *     fiftieth of the samples where there is one per pixel; without effect where memory is too short for it, and on what is returned, even of
 *     a render that is stopped. Where progressive passes are asked for, or paths may end anywhere, none is needed
 * @param clusters whether to return the ray clusters
 * @param chains whether to return the Markov chains
 * @param archives archives that results of units of work are written to, and read from; of this scene and these settings, as far as the
 *     budget is not concerned. They are not closed
 * @param denoised whether to make a second picture without grain, {@link RenderResult#denoised}; physical shading only
 * @param scratch the folder for a picture that is too large for the memory; empty if it is refused
 * @param choice the method that was chosen for scene and settings; empty to choose it where the settings leave that open
 * @param device the device that shades samples beside the processor's threads: {@code cpu} for nothing, {@code opencl} or {@code opencl:N}
 *     for the N-th device, from 0, that a driver for OpenCL offers, {@code auto} for a graphics processor where there is one that can; it
 *     has no influence on the picture
 */
public record RenderRequest(
        Scene scene,
        RenderSettings settings,
        RenderProgress progress,
        BooleanSupplier cancelled,
        Set<RenderResult.Auxiliary> auxiliary,
        boolean progressive,
        boolean watched,
        boolean clusters,
        boolean chains,
        List<RenderResult.Archive> archives,
        boolean denoised,
        Optional<ScratchFolder> scratch,
        Optional<MethodChoice> choice,
        String device) {

    /**
     * Copies the set and the list; nothing may be null.
     *
     * @throws IllegalArgumentException if there are archives, and ray clusters or chains are asked for: what is kept does not tell of them
     */
    public RenderRequest {
        Objects.requireNonNull(scene, "scene");
        Objects.requireNonNull(settings, "settings");
        Objects.requireNonNull(progress, "progress");
        Objects.requireNonNull(cancelled, "cancelled");
        EnumSet<RenderResult.Auxiliary> copy = EnumSet.noneOf(RenderResult.Auxiliary.class);
        copy.addAll(auxiliary);
        auxiliary = Collections.unmodifiableSet(copy);
        archives = List.copyOf(archives);
        Objects.requireNonNull(scratch, "scratch");
        Objects.requireNonNull(device, "device");
        if (!archives.isEmpty() && (clusters || chains)) {
            throw new IllegalArgumentException("results that are kept do not tell of ray clusters and chains");
        }
    }

    /** Just the picture, as the scene asks for it, on all processors. */
    public static RenderRequest of(Scene scene) {
        return of(scene, RenderSettings.of(scene));
    }

    /** Just the picture. */
    public static RenderRequest of(Scene scene, RenderSettings settings) {
        return new RenderRequest(
                scene,
                settings,
                RenderProgress.NONE,
                () -> false,
                Set.of(),
                false,
                false,
                false,
                false,
                List.of(),
                false,
                Optional.empty(),
                Optional.empty(),
                "cpu");
    }

    /** This request with other settings, for which nothing is chosen. */
    public RenderRequest withSettings(RenderSettings value) {
        return withMethod(value, Optional.empty());
    }

    /** This request with the settings of a choice that {@link Renderer#choose} made for its scene. */
    public RenderRequest withChoice(MethodChoice value) {
        return withMethod(value.settings(), Optional.of(value));
    }

    private RenderRequest withMethod(RenderSettings how, Optional<MethodChoice> chosen) {
        return with(c -> {
            c.settings = how;
            c.choice = chosen;
        });
    }

    /** This request with another listener. */
    public RenderRequest withProgress(RenderProgress value) {
        return with(c -> c.progress = value);
    }

    /** This request with another cancellation check, which must return quickly. */
    public RenderRequest withCancelled(BooleanSupplier value) {
        return with(c -> c.cancelled = value);
    }

    /** This request with these auxiliary images beside the colours. */
    public RenderRequest withAuxiliary(Set<RenderResult.Auxiliary> value) {
        return with(c -> c.auxiliary = value);
    }

    /** This request with these auxiliary images beside the colours. */
    public RenderRequest withAuxiliary(RenderResult.Auxiliary... values) {
        EnumSet<RenderResult.Auxiliary> set = EnumSet.noneOf(RenderResult.Auxiliary.class);
        set.addAll(Arrays.asList(values));
        return withAuxiliary(set);
    }

    /** This request with or without the ray clusters. */
    public RenderRequest withClusters(boolean value) {
        return with(c -> c.clusters = value);
    }

    /** This request with or without the Markov chains. */
    public RenderRequest withChains(boolean value) {
        return with(c -> c.chains = value);
    }

    /** This request with or without coarse passes first. */
    public RenderRequest withProgressive(boolean value) {
        return with(c -> c.progressive = value);
    }

    /** This request with or without coarse passes for its listener. */
    public RenderRequest withWatched(boolean value) {
        return with(c -> c.watched = value);
    }

    /** This request with other archives. */
    public RenderRequest withArchives(List<RenderResult.Archive> value) {
        return with(c -> c.archives = value);
    }

    /** This request with or without a second picture, from which grain is removed. */
    public RenderRequest withDenoised(boolean value) {
        return with(c -> c.denoised = value);
    }

    /** This request for a picture that may be kept in a file of this folder while it is rendered. */
    public RenderRequest withScratch(ScratchFolder value) {
        return with(c -> c.scratch = Optional.of(value));
    }

    /** This request with a device that takes part. */
    public RenderRequest withDevice(String value) {
        return with(c -> c.device = value);
    }

    /** The auxiliary images that the request needs: the requested ones, and those that guide denoising. */
    Set<RenderResult.Auxiliary> neededAuxiliary() {
        EnumSet<RenderResult.Auxiliary> all = EnumSet.noneOf(RenderResult.Auxiliary.class);
        all.addAll(auxiliary);
        if (denoised) {
            all.addAll(Denoising.GUIDES);
        }
        return all;
    }

    private RenderRequest with(Consumer<Parts> change) {
        Parts parts = new Parts(this);
        change.accept(parts);
        return parts.request();
    }

    /** The components while some of them are changed. */
    private static final class Parts {
        Scene scene;
        RenderSettings settings;
        RenderProgress progress;
        BooleanSupplier cancelled;
        Set<RenderResult.Auxiliary> auxiliary;
        boolean progressive;
        boolean watched;
        boolean clusters;
        boolean chains;
        List<RenderResult.Archive> archives;
        boolean denoised;
        Optional<ScratchFolder> scratch;
        Optional<MethodChoice> choice;
        String device;

        Parts(RenderRequest of) {
            scene = of.scene;
            settings = of.settings;
            progress = of.progress;
            cancelled = of.cancelled;
            auxiliary = of.auxiliary;
            progressive = of.progressive;
            watched = of.watched;
            clusters = of.clusters;
            chains = of.chains;
            archives = of.archives;
            denoised = of.denoised;
            scratch = of.scratch;
            choice = of.choice;
            device = of.device;
        }

        RenderRequest request() {
            return new RenderRequest(
                    scene,
                    settings,
                    progress,
                    cancelled,
                    auxiliary,
                    progressive,
                    watched,
                    clusters,
                    chains,
                    archives,
                    denoised,
                    scratch,
                    choice,
                    device);
        }
    }

    /**
     * The folder of a picture that is too large for the memory, while it is rendered. Its file there has no name or a new one, and is gone
     * with the picture, or with the process. Listeners see some of its columns and rows only: those of a picture of at most 2¹⁸ pixels.
     *
     * @param folder best that of the finished picture
     * @param memory the most bytes that the pixels may take in memory, at least 0
     */
    public record ScratchFolder(Path folder, long memory) {
        /** The folder may not be null. */
        public ScratchFolder {
            Objects.requireNonNull(folder, "folder");
            if (memory < 0) {
                throw new IllegalArgumentException("memory must be at least 0, not " + memory);
            }
        }

        /** For pictures that take more than half of the memory there is. */
        public static ScratchFolder of(Path folder) {
            return new ScratchFolder(folder, Runtime.getRuntime().maxMemory() / 2);
        }
    }

    /**
     * The method of a render, chosen by the program where the settings leave that to it ({@link enlightenment.scene.Method#AUTO}): what
     * {@link Renderer#choose} gives. A render that is requested with it ({@link RenderRequest#withChoice}) neither chooses nor prepares the
     * scene again. Immutable; keeps the scene in memory.
     */
    public static final class MethodChoice {
        private final RenderSettings settings;
        private final Optional<String> reason;
        private final CompiledScene compiled;
        private final Phases phases;
        private final Stopwatch time;

        /**
         * @param compiled the scene, or null if it was not needed
         * @param phases what was done so far
         * @param time since the choice began
         */
        MethodChoice(
                RenderSettings settings,
                Optional<String> reason,
                CompiledScene compiled,
                Phases phases,
                Stopwatch time) {
            this.settings = settings;
            this.reason = reason;
            this.compiled = compiled;
            this.phases = phases;
            this.time = time;
        }

        /** The settings with a method that renders. */
        public RenderSettings settings() {
            return settings;
        }

        /** Why that method, as a sentence without a full stop; empty if the settings named it. */
        public Optional<String> reason() {
            return reason;
        }

        /**
         * This choice for another render of its scene, which is not prepared again. Its time is counted from now.
         *
         * @param other settings that differ in samples, seed, threads and crop alone; their method is not looked at
         * @throws IllegalArgumentException if their size is another one
         */
        public MethodChoice with(RenderSettings other) {
            if (other.width() != settings.width() || other.height() != settings.height()) {
                throw new IllegalArgumentException("prepared for " + settings.width() + "x" + settings.height()
                        + " pixels, not for " + other.width() + "x" + other.height());
            }
            RenderSettings chosen = other.method() == settings.method() ? other : other.withMethod(settings.method());
            return new MethodChoice(chosen, Optional.empty(), compiled, new Phases(), Stopwatch.started());
        }

        Optional<CompiledScene> compiled() {
            return Optional.ofNullable(compiled);
        }

        Phases phases() {
            return phases.copy();
        }

        Stopwatch time() {
            return time;
        }
    }
}
