package enlightenment.render;

import enlightenment.denoise.Denoiser;
import enlightenment.denoise.NoisyPicture;
import enlightenment.engine.PictureFilm;
import enlightenment.image.Image;
import enlightenment.math.InvalidValueException;
import enlightenment.world.CompiledScene;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CancellationException;

/** The second picture of a render: the same without grain. */
final class Denoising {
    /** The auxiliary images that guide the filter. */
    static final Set<RenderResult.Auxiliary> GUIDES =
            Set.of(RenderResult.Auxiliary.ALBEDO, RenderResult.Auxiliary.NORMAL, RenderResult.Auxiliary.POSITION);

    /** Pictures of floats that it takes in memory. */
    static final int IMAGES = 26;

    private Denoising() {}

    /** @throws InvalidValueException (key {@code denoised}) if pixels are display-referred */
    static void check(CompiledScene scene) {
        if (scene.physical == null) {
            throw new InvalidValueException(
                    "denoised",
                    "removing grain is for physical shading: classic shading does not tell how it comes about");
        }
    }

    /** The picture without grain; empty if it was cancelled. */
    static Optional<Image> of(
            Image picture, PictureFilm film, Map<RenderResult.Auxiliary, Image> guides, RenderRequest request) {
        NoisyPicture noisy = new NoisyPicture(
                picture.width(),
                picture.height(),
                picture.toArray(),
                film.quarterMeans(),
                guides.get(RenderResult.Auxiliary.ALBEDO).toArray(),
                guides.get(RenderResult.Auxiliary.NORMAL).toArray(),
                guides.get(RenderResult.Auxiliary.POSITION).toArray());
        try {
            float[] rgb = Denoiser.denoise(noisy, request.settings().threads(), request.cancelled());
            return Optional.of(new Image(picture.width(), picture.height(), rgb, picture.curve()));
        } catch (CancellationException e) {
            return Optional.empty();
        }
    }
}
