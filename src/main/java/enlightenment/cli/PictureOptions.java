package enlightenment.cli;

import enlightenment.image.Image;
import enlightenment.image.ImageFiles;
import enlightenment.image.PngOptions;
import enlightenment.render.RenderReport;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import java.io.IOException;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import java.util.OptionalDouble;

/** What commands that write pictures check alike. */
final class PictureOptions {
    private PictureOptions() {}

    /** Fails unless the picture's format is known and may have that depth; depth and format may be null. */
    static void check(Path output, String depth, String format) {
        String extension = OutputFile.extension(output);
        String file = "a .pfm file";
        if (Standard.is(output)) {
            file = "--format pfm";
            extension = "." + (format == null ? "png" : OptionValues.word("--format", format, "png", "pfm"));
            if (System.console() != null) {
                throw CliException.wrongUsage("-o - writes a picture to standard output, which is a terminal here");
            }
        } else if (format != null) {
            throw CliException.wrongUsage("--format must only be given with -o -: the name of a file tells its format");
        }
        if (!extension.equals(".png") && !extension.equals(".pfm")) {
            throw CliException.wrongUsage("-o must name a file that ends in .png or .pfm, not \"" + output + "\"");
        }
        checkDepth(depth);
        if (depth != null && extension.equals(".pfm")) {
            throw CliException.wrongUsage("--depth must not be given for " + file + ", which holds floats");
        }
    }

    /** Fails unless it is one, or null. */
    static void checkDepth(String depth) {
        if (depth != null) {
            OptionValues.word("--depth", depth, "8", "16");
        }
    }

    /** Writes the picture to its file or to standard output. */
    static void write(Image image, Path output, String format, PngOptions options, Terminal terminal)
            throws IOException {
        if (!Standard.is(output)) {
            ImageFiles.write(image, output, options);
        } else if ("pfm".equals(format)) {
            ImageFiles.toPfm(image, terminal.out());
        } else {
            ImageFiles.toPng(image, terminal.out(), options);
        }
    }

    /** Shows the statistics where they are not mixed with the picture. */
    static void printStatistics(RenderReport report, Path output, Terminal terminal) {
        (Standard.is(output) ? terminal.err() : terminal.out()).print(StatsTable.of(report));
    }

    /** The settings with what the file adds to an error that is asked for. */
    static RenderSettings forFile(RenderSettings settings, Path output, String format, String depth) {
        return settings.budget().error().isEmpty()
                ? settings
                : settings.withBudget(settings.budget().withDepth(depth(output, format, depth)));
    }

    /** Bits per component of the file, or 0 for floats. */
    static int depth(Path output, String format, String depth) {
        boolean holdsFloats = Standard.is(output)
                ? "pfm".equals(format)
                : OutputFile.extension(output).equals(".pfm");
        return holdsFloats ? 0 : "16".equals(depth) ? 16 : 8;
    }

    /** Whether the finished picture is as exact as was asked; says so if not. */
    static boolean keepsError(RenderReport report, Terminal terminal) {
        if (!report.isErrorMet()) {
            RenderReport.Sampling sampling = report.sampling();
            double asked = report.settings().budget().error().getAsDouble();
            OptionalDouble samples = report.samplesForError();
            terminal.say(String.format(
                    Locale.ROOT,
                    "the error is about %.4g and may be %.4g, more than --error %s; decided by %s%s%s",
                    Math.hypot(sampling.estimatedError(), sampling.rounding()),
                    sampling.errorInFile(),
                    RenderOptions.number(asked),
                    sampling.decidedBy(),
                    samples.isPresent() ? "; try --samples " + RenderOptions.number(samples.getAsDouble()) : "",
                    2 * sampling.rounding() > asked
                            ? "; much of it is the file's rounding: --depth 16 or a .pfm file has less"
                            : ""));
        }
        return report.isErrorMet();
    }

    /** What a picture's file says of itself: nothing that differs from run to run. */
    static Map<String, String> text(Scene scene, String settings) {
        Map<String, String> text = new LinkedHashMap<>();
        if (!scene.name().isEmpty()) {
            // PNG ends a text at a NUL.
            text.put("Title", scene.name().replace('\0', ' '));
        }
        text.put("Software", "Enlightenment " + Version.number());
        text.put("Settings", settings);
        return text;
    }
}
