package enlightenment.cli.picture;

import enlightenment.image.Image;
import enlightenment.image.ImageFiles;
import enlightenment.image.ImageFormat;
import enlightenment.render.RenderResult;
import enlightenment.scene.RenderSettings;
import java.io.IOException;
import java.io.OutputStream;
import java.util.Map;

/** Writes the file of a picture. */
public final class PictureBytes {
    private PictureBytes() {}

    /**
     * Writes a picture to a stream, which stays open.
     *
     * @param format one that is written
     * @param depth bits per component, of a format that has a choice
     * @param texts what the file says of itself, if its format has room for that
     * @param settings of the render: where a crop lies
     * @param layers further numbers of pixels, for OpenEXR
     */
    public static void write(
            Image image,
            ImageFormat format,
            int depth,
            Map<String, String> texts,
            RenderSettings settings,
            Map<RenderResult.Auxiliary, Image> layers,
            OutputStream out)
            throws IOException {
        if (format == ImageFormat.EXR) {
            ImageFiles.toExr(image, out, ExrOutput.options(depth, texts, settings, layers));
        } else {
            int bits = format == ImageFormat.PNG ? depth : PictureOutput.USUAL_DEPTH;
            ImageFiles.write(image, out, format, new ImageFiles.PngOptions(bits, texts));
        }
    }
}
