package enlightenment.cli.picture;

import enlightenment.cli.option.CommandFiles;
import enlightenment.cli.terminal.CliException;
import enlightenment.file.WholeFile;
import enlightenment.image.Image;
import enlightenment.image.ImageFiles;
import enlightenment.image.ImageFormat;
import enlightenment.render.RenderResult;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.Shading;
import java.io.IOException;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import picocli.CommandLine.Option;

/** The option that asks for a second picture, without grain. */
public final class DenoisedOutput {
    private static final String OPTION = "--denoised";

    /** Keyword of the text by which files say what they are, and that text. */
    private static final String KEYWORD = "denoised";

    private static final String TEXT = "grain was removed after the render; its error is not known";

    @Option(
            names = OPTION,
            paramLabel = "FILE",
            description = "physical shading: write a second picture, without grain: .png, .jpg, .exr or .pfm")
    private Path file;

    public DenoisedOutput() {}

    /** Whether the picture is asked for. */
    public boolean isGiven() {
        return file != null;
    }

    /** Fails unless the file's format is one that can be written, of a picture of this scene. */
    public void check(Scene scene, RenderSettings settings) {
        if (!isGiven()) {
            return;
        }
        if (!(scene.shading() instanceof Shading.Physical)) {
            throw CliException.wrongUsage(
                    OPTION
                            + " is for physical shading: of classic shading not enough is known of each pixel to remove its grain");
        }
        RenderSettings.Crop region = settings.region();
        if (Math.max(region.width(), region.height()) > format().largestSide()) {
            throw CliException.wrongUsage(OPTION + ": a picture of " + region.width() + "x" + region.height()
                    + " pixels is too large for JPEG; .png has more");
        }
    }

    private ImageFormat format() {
        return ImageFormat.ofExtension(file)
                .filter(ImageFormat::isWritten)
                .orElseThrow(() -> CliException.wrongUsage(OPTION + " must name a file that ends in "
                        + ImageFormat.extensions(ImageFormat.written()) + ", not \"" + file + "\""));
    }

    /** Adds the file that will be written. */
    public void register(CommandFiles outputs) {
        outputs.writes(OPTION, file);
    }

    /**
     * Writes the picture, if it is asked for and the render has made it.
     *
     * @param shown the picture with its grain: both are shown in one way
     * @param picture where that goes: files of one format have one depth
     * @param texts what that file says of itself
     */
    public void write(
            RenderResult result, Image shown, PictureOutput picture, Map<String, String> texts, RenderSettings settings)
            throws IOException {
        if (!isGiven() || result.denoised().isEmpty()) {
            return;
        }
        Image image = result.denoised().get().withCurve(shown.curve());
        Map<String, String> all = new LinkedHashMap<>(texts);
        all.put(KEYWORD, TEXT);
        ImageFormat format = format();
        int depth = format.holdsFloats() && format.depths().isEmpty() ? 0 : picture.depthFor(format);
        WholeFile.write(file, out -> {
            if (format == ImageFormat.EXR) {
                ImageFiles.toExr(image, out, ExrOutput.options(depth, all, settings, Map.of()));
            } else {
                ImageFiles.write(image, out, format, new ImageFiles.PngOptions(depth(format, depth), all));
            }
        });
    }

    private static int depth(ImageFormat format, int depth) {
        return format == ImageFormat.PNG ? depth : PictureOutput.USUAL_DEPTH;
    }
}
