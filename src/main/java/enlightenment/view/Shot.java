package enlightenment.view;

import enlightenment.render.Film;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.view.frame.PassPlan;

/**
 * What is to be rendered.
 *
 * @param generation counts changes; a picture of an older one is out of date
 * @param scene with the camera of the view
 * @param film what the scene's pictures have in common with those before; another one whenever the file was read
 * @param size of the view
 */
record Shot(long generation, Scene scene, Film film, ViewSize size) {

    /** The settings of a pass: those of the scene, but for size, samples and random numbers, which differ from pass to pass. */
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
