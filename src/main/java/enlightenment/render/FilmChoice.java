package enlightenment.render;

import enlightenment.engine.FilmPlace;
import enlightenment.engine.FilmRoom;
import enlightenment.plan.Integrators;
import enlightenment.plan.RenderPlan;
import enlightenment.scene.Method;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.work.PictureMemory;
import enlightenment.world.CompiledScene;
import java.util.Optional;

/** Decides whether the pixels of a render are in memory or in a file, and refuses what fits nowhere. */
final class FilmChoice {
    private final RenderRequest request;
    private final RenderSettings settings;
    private final int images;
    private final FilmRoom room;

    /** @param images how many further images as large as the picture are needed in memory */
    FilmChoice(RenderRequest request, int images) {
        this.request = request;
        settings = request.settings();
        this.images = images;
        room = request.scratch()
                .map(s -> new FilmRoom(Optional.of(s.folder()), s.memory()))
                .orElse(FilmRoom.MEMORY);
    }

    /**
     * Refuses, before anything is done, what can be neither in memory nor in a file.
     *
     * @throws enlightenment.math.InvalidValueException if there is too little memory, or too little space in the folder
     */
    void check() {
        room.place(memory(films(settings.method())), inMemoryFor());
    }

    /**
     * Refuses, before anything is planned, a scene of which paths from lights must be added.
     *
     * @throws enlightenment.math.InvalidValueException if there is too little memory for them, or too little space in the folder
     */
    void check(CompiledScene scene) {
        if (Integrators.hasLightPaths(settings.method(), scene, settings)) {
            room.place(memory(PictureMemory.Films.BOTH), inMemoryFor());
        }
    }

    /** Whether memory suffices for one more image, which the render can do without. */
    boolean hasRoom(CompiledScene scene) {
        PictureMemory more = PictureMemory.of(request.scene(), settings, PictureMemory.Films.BOTH, images + 1);
        boolean hasPaths = Integrators.hasLightPaths(settings.method(), scene, settings);
        PictureMemory.Films films = hasPaths ? PictureMemory.Films.BOTH : films(settings.method());
        return !room.isExceededBy(memory(films)) && more.isEnough();
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

    /** The kind of films that a method accumulates, whatever the scene. */
    private static PictureMemory.Films films(Method method) {
        if (method.kind() == Method.Kind.SPLATS) {
            return PictureMemory.Films.SPLATS;
        }
        return Integrators.alwaysHasLightPaths(method) ? PictureMemory.Films.BOTH : PictureMemory.Films.TILES;
    }

    /**
     * The place of the pixels: memory or a file.
     *
     * @throws enlightenment.math.InvalidValueException if there is too little memory, or too little space in the folder
     */
    FilmPlace place(RenderPlan plan) {
        PictureMemory.Films films = plan.lightPaths() > 0 ? PictureMemory.Films.BOTH : films(settings.method());
        return room.place(memory(films), inMemoryFor());
    }

    /** The part of the request that needs the whole picture in memory; empty without one. */
    private Optional<String> inMemoryFor() {
        Optional<String> method = FilmRoom.wholeInMemory(settings.method());
        if (method.isPresent()) {
            return method;
        }
        if (request.denoised()) {
            return Optional.of("removing grain");
        }
        if (request.progressive()) {
            return Optional.of("a preview");
        }
        return request.auxiliary().isEmpty() ? Optional.empty() : Optional.of("a picture beside the colours");
    }
}
