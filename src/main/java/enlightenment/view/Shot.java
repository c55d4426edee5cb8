package enlightenment.view;

import enlightenment.render.Film;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.view.frame.PassPlan;

/**
 * Scene and size of one picture of a view.
 *
 * @param generation number of changes of the view so far; a picture of an older generation is out of date
 * @param scene the scene with the camera of the view
 * @param film images and material tables that are shared with earlier pictures; a new one whenever the file is read
 * @param size size of the view
 */
record Shot(long generation, Scene scene, Film film, ViewSize size) {

    /** The scene's settings with the size, samples and seed of a pass. */
    RenderSettings settings(PassPlan pass, int threads) {
        RenderSettings usual = RenderSettings.of(scene);
        return usual.toBuilder()
                .size(pass.side(size.width()), pass.side(size.height()))
                .budget(usual.budget().withSamples(pass.samples()))
                .seed(usual.seed() + pass.number())
                .threads(threads)
                .build();
    }
}
