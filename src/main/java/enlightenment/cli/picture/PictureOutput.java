package enlightenment.cli.picture;

import enlightenment.cli.option.FileNames;
import enlightenment.cli.option.WordOption;
import enlightenment.cli.terminal.CliException;
import enlightenment.cli.terminal.StandardStreams;
import enlightenment.cli.terminal.Terminal;
import enlightenment.image.Image;
import enlightenment.image.ImageFiles;
import enlightenment.image.ImageFormat;
import enlightenment.image.PngOptions;
import enlightenment.render.RenderResult;
import enlightenment.scene.RenderSettings;
import java.io.IOException;
import java.nio.file.Path;
import picocli.CommandLine.Option;

/** The options that say where a picture goes and in which format. */
public final class PictureOutput {
    public static final int USUAL_DEPTH = 8;

    @Option(
            names = {"-o", "--output"},
            required = true,
            paramLabel = "FILE",
            description = "the picture: .png, .jpg, or .pfm for exact floats; - for standard output")
    private Path file;

    @Option(
            names = "--format",
            paramLabel = "FORMAT",
            converter = Formats.class,
            completionCandidates = Formats.class,
            description = "format on standard output, only with -o -: png (default), jpg or pfm")
    private ImageFormat format;

    @Option(
            names = "--depth",
            paramLabel = "BITS",
            converter = Depths.class,
            completionCandidates = Depths.class,
            description = "bits per component of a PNG file: 8 (default) or 16")
    private Integer depth;

    public PictureOutput() {}

    public Path file() {
        return file;
    }

    /** What messages call it. */
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
                    format.holdsFloats()
                            ? "--depth must not be given for " + what + ", which holds floats"
                            : "--depth " + depth + " must not be given for " + what + ", which holds "
                                    + format.depths().get(0) + " bits per component; .png holds 16");
        }
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

    /** Bits per component of a PNG file; a JPEG file has the usual depth only. */
    public int depth() {
        return hasDepth() ? depth : USUAL_DEPTH;
    }

    /** Bits per component of what is written; 0 for floats. */
    public int writtenDepth() {
        return format().holdsFloats() ? 0 : depth();
    }

    /** The settings with the rounding of the written file, which counts where an error is asked for. */
    public static RenderSettings withRounding(RenderSettings settings, int writtenDepth) {
        return settings.budget().error().isEmpty()
                ? settings
                : settings.withBudget(settings.budget().withDepth(writtenDepth));
    }

    /** Writes the picture. */
    public void write(Image image, PngOptions options, Terminal terminal) throws IOException {
        if (isStandardOutput()) {
            ImageFiles.write(image, terminal.out(), format(), options);
        } else {
            ImageFiles.write(image, file, options);
        }
    }

    /** Says so if the finished picture is nearly black or nearly white in this file. */
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

    /** The depths of PNG files. */
    public static final class Depths extends WordOption<Integer> {
        Depths() {
            super(ImageFormat.PNG.depths());
        }
    }

    /** The failure of a render that was stopped before there was anything to write. */
    public CliException nothingRendered() {
        return CliException.failed("stopped before anything was rendered; " + name() + " was not written");
    }
}
