package enlightenment.cli.picture;

import enlightenment.cli.option.CommandFiles;
import enlightenment.cli.option.FileNames;
import enlightenment.cli.option.WordOption;
import enlightenment.cli.terminal.CliException;
import enlightenment.cli.terminal.StandardStreams;
import enlightenment.cli.terminal.Terminal;
import enlightenment.file.WholeFile;
import enlightenment.image.Image;
import enlightenment.image.ImageFiles;
import enlightenment.image.ImageFormat;
import enlightenment.render.RenderRequest;
import enlightenment.render.RenderResult;
import enlightenment.scene.RenderSettings;
import enlightenment.text.WordList;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import picocli.CommandLine.Option;

/** The options that say where a picture goes and in which format. */
public final class PictureOutput {
    public static final int USUAL_DEPTH = 8;

    @Option(
            names = {"-o", "--output"},
            required = true,
            paramLabel = "FILE",
            description = "the picture: .png, .jpg, or .exr or .pfm for floats; - for standard output")
    private Path file;

    @Option(
            names = "--format",
            paramLabel = "FORMAT",
            converter = Formats.class,
            completionCandidates = Formats.class,
            description = "format on standard output, only with -o -: png (default), jpg, pfm or exr")
    private ImageFormat format;

    @Option(
            names = "--depth",
            paramLabel = "BITS",
            converter = Depths.class,
            completionCandidates = Depths.class,
            description = "bits per component: 8 (default) or 16 of a PNG file, 32 (default) or 16 of an EXR file")
    private Integer depth;

    public PictureOutput() {}

    public Path file() {
        return file;
    }

    /** The name of the output in messages. */
    public String name() {
        return StandardStreams.outputName(file);
    }

    public boolean isStandardOutput() {
        return StandardStreams.isNamed(file);
    }

    private boolean hasFormat() {
        return format != null;
    }

    private boolean hasDepth() {
        return depth != null;
    }

    /** Fails unless the picture's format is one that can be written, and may have the depth that was given. */
    public void check() {
        if (isStandardOutput() && System.console() != null) {
            throw CliException.wrongUsage("-o - writes a picture to standard output, which is a terminal here");
        }
        if (!isStandardOutput() && hasFormat()) {
            throw CliException.wrongUsage("--format must only be given with -o -: the name of a file tells its format");
        }
        ImageFormat format = format();
        if (hasDepth() && !format.depths().contains(depth)) {
            String what = isStandardOutput()
                    ? "--format " + new Formats().word(format)
                    : "a " + FileNames.extension(file) + " file";
            throw CliException.wrongUsage(
                    format.depths().isEmpty()
                            ? "--depth must not be given for " + what + ", which holds floats"
                            : "--depth " + depth + " must not be given for " + what + ", which holds "
                                    + WordList.join(
                                            format.depths().stream()
                                                    .map(String::valueOf)
                                                    .toList(),
                                            "or")
                                    + " bits per component; " + extensionOf(depth) + " holds " + depth);
        }
    }

    private static String extensionOf(int depth) {
        return ImageFormat.extensions(ImageFormat.written().stream()
                .filter(f -> f.depths().contains(depth))
                .limit(1)
                .toList());
    }

    /** Fails if a picture rendered like that cannot be kept in this format. */
    public void check(RenderSettings settings) {
        ImageFormat format = format();
        RenderSettings.Crop region = settings.region();
        if (Math.max(region.width(), region.height()) > format.largestSide()) {
            throw CliException.wrongUsage("a picture of " + region.width() + "x" + region.height()
                    + " pixels is too large for JPEG, which has at most " + format.largestSide()
                    + " columns and rows here; .png has more");
        }
        if (format.isLossy() && settings.budget().error().isPresent()) {
            throw CliException.wrongUsage(
                    "--error is the error of the file, and what JPEG loses is not measured:" + " choose .png or .pfm");
        }
        if (format == ImageFormat.EXR
                && depth() != ImageFiles.ExrOptions.DEFAULT.depth()
                && settings.budget().error().isPresent()) {
            throw CliException.wrongUsage(
                    "--error is the error of the file, and what floats of 16 bits lose is not measured: leave out --depth 16");
        }
    }

    /** The format of the file, or of what goes to standard output. */
    private ImageFormat format() {
        if (isStandardOutput()) {
            return hasFormat() ? format : ImageFormat.PNG;
        }
        return ImageFormat.ofExtension(file)
                .filter(ImageFormat::isWritten)
                .orElseThrow(() -> CliException.wrongUsage("-o must name a file that ends in "
                        + ImageFormat.extensions(ImageFormat.written()) + ", not \"" + file + "\""));
    }

    /** Bits per component, of a format that has a choice. */
    private int depth() {
        return hasDepth() ? depth : usualDepth(format());
    }

    private static int usualDepth(ImageFormat of) {
        return of.depths().isEmpty() ? USUAL_DEPTH : of.depths().get(0);
    }

    /** Bits per component of another picture beside this one: as many, if it has this format. */
    int depthFor(ImageFormat other) {
        return other == format() ? depth() : usualDepth(other);
    }

    /** Bits per component of what is written; 0 for floats. */
    public int writtenDepth() {
        return format().holdsFloats() ? 0 : depth();
    }

    /** Bits per component of the picture that a part is rendered for, whose format is not known yet; 0 for floats. */
    public int depthOfWhole() {
        return !hasDepth() ? USUAL_DEPTH : ImageFormat.PNG.depths().contains(depth) ? depth : 0;
    }

    /** Whether further numbers of pixels are written as channels of the picture, rather than as files beside it. */
    public boolean holdsLayers() {
        return format() == ImageFormat.EXR;
    }

    /** The settings with the rounding of the written file, which counts where an error is asked for. */
    public static RenderSettings withRounding(RenderSettings settings, int writtenDepth) {
        return settings.budget().error().isEmpty()
                ? settings
                : settings.withBudget(settings.budget().withDepth(writtenDepth));
    }

    /** The folder of the file, for a picture too large for the memory. Empty where the format cannot be written row by row. */
    public Optional<RenderRequest.ScratchFolder> scratch() {
        Path folder = file.toAbsolutePath().getParent();
        return isStandardOutput() || folder == null || CommandFiles.isDevice(file) || format() == ImageFormat.JPEG
                ? Optional.empty()
                : Optional.of(RenderRequest.ScratchFolder.of(folder));
    }

    /** Writes the picture, which is all that is written of the render. */
    public void write(Image image, Map<String, String> texts, RenderSettings settings, Terminal terminal)
            throws IOException {
        write(image, texts, settings, Map.of(), terminal);
    }

    /**
     * Writes the picture.
     *
     * @param texts what the file says of itself, if its format has room for that
     * @param settings of the render: where a crop lies
     * @param layers further numbers of pixels, for a file that {@link #holdsLayers}
     */
    public void write(
            Image image,
            Map<String, String> texts,
            RenderSettings settings,
            Map<RenderResult.Auxiliary, Image> layers,
            Terminal terminal)
            throws IOException {
        if (isStandardOutput()) {
            write(image, texts, settings, layers, terminal.out());
        } else {
            WholeFile.write(file, out -> write(image, texts, settings, layers, out));
        }
    }

    private void write(
            Image image,
            Map<String, String> texts,
            RenderSettings settings,
            Map<RenderResult.Auxiliary, Image> layers,
            OutputStream out)
            throws IOException {
        PictureBytes.write(image, format(), depth(), texts, settings, layers, out);
    }

    /** The options of PNG files, of the picture or beside it. */
    public ImageFiles.PngOptions pngOptions(Map<String, String> texts) {
        return new ImageFiles.PngOptions(format() == ImageFormat.PNG ? depth() : USUAL_DEPTH, texts);
    }

    /** Reports a finished picture that is nearly black or nearly white in this file. */
    public void tellBrightness(RenderResult result, Image shown, Terminal terminal) {
        BrightnessHint.tell(result, shown, format().holdsFloats(), (kind, text) -> terminal.say(text));
    }

    /** The formats that can be written. */
    static final class Formats extends WordOption<ImageFormat> {
        Formats() {
            super(ImageFormat.written());
        }

        @Override
        protected String word(ImageFormat format) {
            return format.extensions().get(0);
        }
    }

    /** The depths of files of any format. */
    static final class Depths extends WordOption<Integer> {
        Depths() {
            super(List.of(8, 16, 32));
        }
    }

    /** The depths of PNG files. */
    public static final class PngDepths extends WordOption<Integer> {
        PngDepths() {
            super(ImageFormat.PNG.depths());
        }
    }

    /** The failure of a render that was stopped before there was anything to write. */
    public CliException nothingRendered() {
        return CliException.failed("stopped before anything was rendered; " + name() + " was not written");
    }
}
