package enlightenment.cli.picture;

import enlightenment.image.Image;
import enlightenment.image.ImageFiles;
import enlightenment.render.RenderResult;
import enlightenment.scene.RenderSettings;
import java.util.Map;
import java.util.Optional;

/** The metadata and layers of an OpenEXR file. */
final class ExrOutput {
    private ExrOutput() {}

    /**
     * The options by which a render's picture is written.
     *
     * @param depth bits per component
     * @param layers numbers that become channels, each kind in a layer of its name
     */
    static ImageFiles.ExrOptions options(
            int depth, Map<String, String> texts, RenderSettings settings, Map<RenderResult.Auxiliary, Image> layers) {
        RenderSettings.Crop region = settings.region();
        ImageFiles.ExrOptions.Place place =
                new ImageFiles.ExrOptions.Place(region.x(), region.y(), settings.width(), settings.height());
        return new ImageFiles.ExrOptions(
                depth,
                Optional.of(place),
                texts,
                layers.entrySet().stream()
                        .map(e -> new ImageFiles.ExrOptions.Layer(
                                e.getKey().word(), e.getKey().channels(), e.getValue()))
                        .toList());
    }
}
