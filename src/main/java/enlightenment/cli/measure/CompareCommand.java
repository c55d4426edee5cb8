package enlightenment.cli.measure;

import enlightenment.cli.option.CommandFiles;
import enlightenment.cli.option.DecimalNumber;
import enlightenment.cli.option.OptionRule;
import enlightenment.cli.option.OptionRules;
import enlightenment.cli.option.Subcommand;
import enlightenment.cli.option.WordOption;
import enlightenment.cli.picture.ViewOption;
import enlightenment.cli.terminal.CliException;
import enlightenment.cli.terminal.ExitCode;
import enlightenment.cli.terminal.Terminal;
import enlightenment.cli.terminal.Version;
import enlightenment.color.Color;
import enlightenment.color.DisplayCurve;
import enlightenment.file.FileFailure;
import enlightenment.image.Image;
import enlightenment.image.ImageError;
import enlightenment.image.ImageFiles;
import enlightenment.image.ImageFormat;
import enlightenment.image.flip.Flip;
import enlightenment.math.InvalidValueException;
import enlightenment.picture.HeatMap;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code enlightenment compare}: measures by how much one picture differs from another. */
@Command(name = "compare", description = "Measures by how much one picture differs from another.", sortOptions = false)
public final class CompareCommand extends Subcommand {
    @Parameters(
            index = "0",
            paramLabel = "A",
            description = "the picture to judge: .png, .pfm, .hdr, .exr, .jpg or .bmp")
    private Path test;

    @Parameters(
            index = "1",
            paramLabel = "B",
            description = "the reference: a picture of the same size, .png, .pfm, .hdr, .exr, .jpg or .bmp")
    private Path reference;

    @Option(names = "--heatmap", paramLabel = "OUT.png", description = "write a picture of where they differ (FLIP)")
    private Path heatMap;

    @Option(names = "--json", description = "print the figures as JSON")
    private boolean json;

    @Option(
            names = "--linear",
            description =
                    "both pictures are float maps of linear light, as physical shading makes them: compare what a screen"
                            + " shows, and light")
    private boolean linear;

    @Option(
            names = "--exposure",
            paramLabel = "N",
            converter = ViewOption.Stops.class,
            description = "with --linear: compare them 2^N times as bright as they are (default: 0)")
    private Double exposure;

    @Option(
            names = "--tone",
            paramLabel = "TONE",
            converter = Tones.class,
            completionCandidates = Tones.class,
            description = "with --linear: the tone curve, ${COMPLETION-CANDIDATES} (default: clip)")
    private DisplayCurve.Tone tone;

    @Option(
            names = "--max-rmse",
            paramLabel = "X",
            converter = MaxRmse.class,
            description = "exit with 1 if the RMSE is larger than this")
    private Double maxRmse;

    @Option(
            names = "--pixels-per-degree",
            paramLabel = "N",
            converter = PixelsPerDegree.class,
            description = "for FLIP: pixels per degree of the viewer's visual angle, 1..1000 (default: 67.02)")
    private double pixelsPerDegree = Flip.DEFAULT_PIXELS_PER_DEGREE;

    public CompareCommand(Terminal terminal) {
        super(terminal);
    }

    @Override
    public List<OptionRule> rules() {
        return OptionRules.COMPARE;
    }

    @Override
    protected int execute() throws IOException {
        checkHeatMap();
        Image a = read(test);
        Image b = read(reference);
        if (a.width() != b.width() || a.height() != b.height()) {
            throw CliException.wrongUsage("the pictures differ in size: " + test + " has " + size(a) + " pixels, "
                    + reference + " has " + size(b));
        }
        ImageError error;
        Flip flip;
        ImageError.OfLight light;
        try {
            light = linear ? ImageError.OfLight.between(a, b) : null;
            error = ImageError.between(a.toDisplay(), b.toDisplay());
            flip = Flip.between(a, b, pixelsPerDegree);
        } catch (InvalidValueException e) {
            throw CliException.wrongUsage((e.key().equals("test") ? test : reference) + ": " + e.problem());
        }
        if (heatMap != null) {
            ImageFiles.writePng(HeatMap.withScale(flip), heatMap, comments(flip, pixelsPerDegree));
        }
        Comparison comparison = new Comparison(test, reference, error, light, flip, pixelsPerDegree, maxRmse);
        terminal.out().print(json ? ComparisonJson.of(comparison) : comparison.toTable());
        if (!comparison.passed()) {
            throw CliException.failed(
                    "the RMSE is " + error.rmse() + ", larger than --max-rmse " + DecimalNumber.plain(maxRmse));
        }
        return ExitCode.DONE;
    }

    private void checkHeatMap() throws IOException {
        if (heatMap == null) {
            return;
        }
        if (ImageFormat.ofExtension(heatMap).orElse(null) != ImageFormat.PNG) {
            throw CliException.wrongUsage("--heatmap must name a file that ends in .png, not \"" + heatMap + "\"");
        }
        new CommandFiles()
                .reads("picture A", test)
                .reads("the reference B", reference)
                .writes("--heatmap", heatMap)
                .check();
    }

    /** Whatever keeps a picture from being read, the exit code must not be the one of pictures that differ. */
    private Image read(Path file) {
        try {
            if (!linear) {
                return ImageFiles.read(file);
            }
            DisplayCurve curve =
                    DisplayCurve.of(exposure == null ? 0 : exposure, tone == null ? DisplayCurve.Tone.CLIP : tone);
            return ImageFiles.read(file, Color.Encoding.LINEAR).withCurve(curve);
        } catch (IOException e) {
            String reason = FileFailure.described(e);
            // A file that is too large for this process is none that could not be used.
            throw isOutOfMemory(e) ? CliException.failed(reason) : CliException.wrongUsage(reason);
        }
    }

    private static boolean isOutOfMemory(Throwable failure) {
        return failure != null && (failure instanceof OutOfMemoryError || isOutOfMemory(failure.getCause()));
    }

    /** The texts in the file: nothing that differs from run to run. */
    private static ImageFiles.PngOptions comments(Flip flip, double density) {
        return ImageFiles.PngOptions.DEFAULT
                .withText("Title", "FLIP error")
                .withText("Software", "Enlightenment " + Version.number())
                .withText(
                        "Comment",
                        String.format(
                                Locale.ROOT,
                                "FLIP: mean %.6f, largest %.6f, %.2f pixels per degree; magma, 0..1",
                                flip.mean(),
                                flip.largest(),
                                density));
    }

    private static String size(Image image) {
        return image.width() + "x" + image.height();
    }

    static final class Tones extends WordOption<DisplayCurve.Tone> {
        Tones() {
            super(List.of(DisplayCurve.Tone.values()));
        }

        @Override
        protected String word(DisplayCurve.Tone value) {
            return value.name().toLowerCase(Locale.ROOT);
        }
    }

    static final class MaxRmse extends DecimalNumber {
        MaxRmse() {
            super(0, Double.MAX_VALUE);
        }
    }

    static final class PixelsPerDegree extends DecimalNumber {
        PixelsPerDegree() {
            super(Flip.MIN_PIXELS_PER_DEGREE, Flip.MAX_PIXELS_PER_DEGREE);
        }
    }
}
