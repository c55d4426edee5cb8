package enlightenment.importer;

import enlightenment.camera.Camera;
import enlightenment.importer.support.ImportDraft;
import enlightenment.math.InvalidValueException;
import enlightenment.scene.Animation;
import enlightenment.scene.Scene;
import enlightenment.scene.Shading;
import java.util.List;
import java.util.Optional;

/** Makes a scene of a draft: adds the view and the light that the file lacks, or that the options replace. */
final class DraftFinish {
    /** The number of notes that say why there is nothing to be seen. */
    private static final int MOST_REASONS = 3;

    private final ImportDraft draft;
    private final SceneImporter.Options options;
    private final SceneImporter.Options.Up up;

    DraftFinish(ImportDraft draft, SceneImporter.Options options) {
        this.draft = draft;
        this.options = options;
        up = options.up().orElse(draft.isUpZ() ? SceneImporter.Options.Up.Z : SceneImporter.Options.Up.Y);
    }

    /**
     * The scene.
     *
     * @throws InvalidValueException if the file shows nothing, or an option has no meaning for it
     */
    Scene scene(String name) {
        if (draft.objects().isEmpty()) {
            throw new InvalidValueException("objects", "there is nothing to be seen in the file" + leftOut());
        }
        int width = draft.width() == 0 ? Studio.WIDTH : draft.width();
        int height = draft.height() == 0 ? Studio.HEIGHT : draft.height();
        SceneImporter.Options.Orbit orbit = options.orbit().orElse(SceneImporter.Options.Orbit.USUAL);
        Studio studio = new Studio(draft.objects(), up, orbit, (double) width / height);
        Optional<Camera> own = options.orbit().isPresent() ? Optional.empty() : draft.camera();
        Camera camera = own.orElseGet(studio::camera);
        boolean isModel = own.isEmpty() && !draft.isLit();
        if (options.up().isPresent() && own.isPresent() && draft.isLit()) {
            draft.notes().add("", "the axis upwards has no influence: the file has a camera and light");
        }
        addLight(studio, isModel);
        Scene.Builder scene = Scene.builder()
                .name(name)
                .size(width, height)
                .camera(camera)
                .shading(new Shading.Physical(draft.maxBounces(), draft.background(), Optional.empty()))
                .display(new Scene.Display(draft.exposure(), Scene.Display.DEFAULT.tone()));
        draft.materials().forEach(scene::material);
        draft.lights().forEach(scene::light);
        draft.objects().forEach(scene::object);
        animation(own.isPresent()).ifPresent(scene::animation);
        return scene.build();
    }

    /** What may be why: the first things that were left out. */
    private String leftOut() {
        List<String> notes = draft.notes().list();
        if (notes.isEmpty()) {
            return "";
        }
        int more = notes.size() - MOST_REASONS;
        return ": " + String.join("; ", notes.subList(0, Math.min(notes.size(), MOST_REASONS)))
                + (more > 0 ? "; and " + more + " more" : "");
    }

    /** How objects move; not the camera, if that is not the file's. */
    private Optional<Animation> animation(boolean hasOwnCamera) {
        return draft.animation()
                .map(all -> hasOwnCamera
                        ? all
                        : new Animation(
                                all.frames(),
                                all.framesPerSecond(),
                                all.tracks().stream()
                                        .filter(t -> !t.target().startsWith("/camera/"))
                                        .toList()))
                .filter(all -> !all.tracks().isEmpty());
    }

    /** Surroundings as chosen, or the studio's where nothing shines; the lamp where no light is left; a ground below a mere model. */
    private void addLight(Studio studio, boolean isModel) {
        boolean wasLit = draft.isLit();
        if (options.backdrop().isPresent() || !wasLit) {
            draft.background(
                    background(options.backdrop().orElse(new SceneImporter.Options.Backdrop.Studio()), studio));
        }
        boolean isSky = draft.background() instanceof Shading.Background.Sky;
        if (!draft.hasLights() && !isSky && (options.backdrop().isPresent() || !wasLit)) {
            studio.addLamp(draft);
        }
        boolean isPlain = options.backdrop().isPresent()
                && options.backdrop().get() instanceof SceneImporter.Options.Backdrop.Constant;
        if (isModel && !isPlain && studio.isSeenFromAbove()) {
            studio.addGround(draft);
        }
        if (!wasLit && draft.leavesOutLights()) {
            draft.notes().add("", "all lights of the file are left out: a soft light stands in for them");
        }
    }

    private Shading.Background background(SceneImporter.Options.Backdrop backdrop, Studio studio) {
        if (backdrop instanceof SceneImporter.Options.Backdrop.Constant constant) {
            return new Shading.Background.Constant(constant.radiance());
        } else if (backdrop instanceof SceneImporter.Options.Backdrop.Sky) {
            if (up != SceneImporter.Options.Up.Y) {
                throw new InvalidValueException("background", "a sky stands above models whose y axis points upwards");
            }
            return studio.clearSky();
        }
        return Studio.sky();
    }
}
