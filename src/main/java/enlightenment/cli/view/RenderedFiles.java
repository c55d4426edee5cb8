package enlightenment.cli.view;

import enlightenment.cli.picture.PictureBytes;
import enlightenment.cli.picture.PictureText;
import enlightenment.cli.setting.SettingsLine;
import enlightenment.image.ImageFormat;
import enlightenment.render.RenderResult;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.view.PictureFiles;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.Map;
import java.util.OptionalInt;

/** The files of a view's final renders, as {@code render} writes them. */
final class RenderedFiles implements PictureFiles {
    @Override
    public byte[] bytes(Scene scene, OptionalInt frame, RenderResult result, ImageFormat format) throws IOException {
        RenderSettings settings = result.report().settings();
        double samples = result.report().sampling().plannedSamples();
        String line = SettingsLine.replayable(settings, samples, frame.isPresent() ? frame.getAsInt() : null);
        Map<String, String> texts = PictureText.of(scene, line);
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        PictureBytes.write(result.image(), format, format.depths().get(0), texts, settings, result.auxiliary(), out);
        return out.toByteArray();
    }
}
