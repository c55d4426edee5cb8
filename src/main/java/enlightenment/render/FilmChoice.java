package enlightenment.render;

import enlightenment.check.Check;
import enlightenment.engine.FilmPlace;
import enlightenment.file.ScratchFile;
import enlightenment.film.FilmInFile;
import enlightenment.plan.Integrators;
import enlightenment.plan.RenderPlan;
import enlightenment.scene.Method;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.Shading;
import enlightenment.work.PictureMemory;
import enlightenment.world.CompiledScene;
import java.nio.file.Path;
import java.util.Optional;

/** Decides whether the pixels of a render are in memory or in a file, and refuses what fits nowhere. */
final class FilmChoice {
    /** The most that a written picture takes per pixel. */
    private static final long WRITTEN_BYTES = 3 * 4;

    /** Rows of pixels that are in a file may take one half of the memory. */
    private static final int SHARE_OF_ROWS = 2;

    private final RenderRequest request;
    private final RenderSettings settings;
    private final int images;
    private final boolean isLinear;

    /** @param images how many further images as large as the picture are needed in memory */
    FilmChoice(RenderRequest request, int images) {
        this.request = request;
        settings = request.settings();
        this.images = images;
        isLinear = request.scene().shading() instanceof Shading.Physical;
    }

    /**
     * Refuses, before anything is done, what can be neither in memory nor in a file.
     *
     * @throws enlightenment.math.InvalidValueException if there is too little memory, or too little space in the folder
     */
    void check() {
        if (isLarge() && inMemoryFor().isEmpty()) {
            checkFile(request.scratch().get().folder());
        } else {
            memory(films(settings.method())).check(reason(inMemoryFor()));
        }
    }

    /**
     * Refuses, before anything is planned, a scene of which paths from lights must be added.
     *
     * @throws enlightenment.math.InvalidValueException if there is too little memory for them
     */
    void check(CompiledScene scene) {
        if (Integrators.hasLightPaths(settings.method(), scene, settings)) {
            checkPaths();
        }
    }

    /** Whether one more image may be in memory, which the render can do without. */
    boolean hasRoom() {
        PictureMemory more = PictureMemory.of(request.scene(), settings, PictureMemory.Films.BOTH, images + 1);
        return !isLarge() && more.isEnough();
    }

    private void checkPaths() {
        memory(PictureMemory.Films.BOTH).check(reason(inMemoryFor().or(() -> Optional.of("the pass of caustics"))));
    }

    private PictureMemory memory(PictureMemory.Films films) {
        return PictureMemory.of(request.scene(), settings, films, images);
    }

    /**
     * The memory of a picture, in bytes.
     *
     * @param compiled the scene, which may need paths from lights; null if it is not compiled
     */
    static long memory(Scene scene, RenderSettings settings, CompiledScene compiled) {
        boolean hasPaths = compiled != null && Integrators.hasLightPaths(settings.method(), compiled, settings);
        PictureMemory.Films films = hasPaths ? PictureMemory.Films.BOTH : films(settings.method());
        return PictureMemory.of(scene, settings, films, 0).bytes();
    }

    /** What a method makes pictures in, whatever the scene. */
    private static PictureMemory.Films films(Method method) {
        if (method.kind() == Method.Kind.SPLATS) {
            return PictureMemory.Films.SPLATS;
        }
        return Integrators.alwaysHasLightPaths(method) ? PictureMemory.Films.BOTH : PictureMemory.Films.TILES;
    }

    /**
     * Where the pixels are.
     *
     * @throws enlightenment.math.InvalidValueException if paths that may end anywhere are planned, and there is too little memory
     */
    FilmPlace place(RenderPlan plan) {
        if (plan.lightPaths() > 0) {
            checkPaths();
            return FilmPlace.MEMORY;
        }
        return isLarge() && inMemoryFor().isEmpty()
                ? FilmPlace.in(request.scratch().get().folder())
                : FilmPlace.MEMORY;
    }

    private long pixels() {
        return (long) settings.region().width() * settings.region().height();
    }

    /** Whether the picture is too large for the memory that it may take. */
    private boolean isLarge() {
        long bytes = PictureMemory.of(request.scene(), settings, PictureMemory.Films.TILES, 0)
                .bytes();
        return request.scratch().isPresent() && bytes > request.scratch().get().memory();
    }

    /** What of the request needs the whole picture in memory; empty if nothing does. */
    private Optional<String> inMemoryFor() {
        if (settings.method().kind() != Method.Kind.TILES || Integrators.alwaysHasLightPaths(settings.method())) {
            return Optional.of("the method " + settings.method().word());
        }
        if (request.denoised()) {
            return Optional.of("removing grain");
        }
        if (request.progressive()) {
            return Optional.of("a preview");
        }
        return request.auxiliary().isEmpty() ? Optional.empty() : Optional.of("a picture beside the colours");
    }

    private String reason(Optional<String> what) {
        return what.map(w -> "; " + w + " needs all of it in memory").orElse("");
    }

    private void checkFile(Path folder) {
        RenderSettings.Crop region = settings.region();
        String picture = "a picture of " + region.width() + "x" + region.height() + " pixels needs ";
        long memory = Runtime.getRuntime().maxMemory();
        long rows = FilmInFile.memory(region.width(), isLinear);
        Check.that(
                rows <= memory / SHARE_OF_ROWS,
                "size",
                picture + SHARE_OF_ROWS * rows + " bytes of memory for some of its rows; at most " + memory
                        + " are there (java -Xmx sets the limit)");
        long needed = pixels() * (FilmInFile.bytesPerPixel(isLinear) + WRITTEN_BYTES);
        long usable = ScratchFile.usableSpace(folder);
        Check.that(
                needed <= usable,
                "size",
                picture + needed + " bytes on the disk, for a file in " + folder + " while it is rendered; only "
                        + usable + " are free");
    }
}
