package enlightenment.cli.picture;

import enlightenment.cli.option.DecimalNumber;
import enlightenment.cli.terminal.CliException;
import enlightenment.render.RenderResult;
import enlightenment.report.RenderReport;
import java.util.Locale;
import java.util.OptionalDouble;

/** Whether a finished picture is as exact as {@code --error} asks. */
public final class RequestedError {
    private RequestedError() {}

    /** Fails if an error was asked for and is not met. */
    public static void require(RenderResult result) {
        RenderReport report = result.report();
        if (report.isErrorMet()) {
            return;
        }
        RenderReport.Sampling sampling = report.sampling();
        double asked = report.settings().budget().error().getAsDouble();
        OptionalDouble samples = result.samplesForError();
        throw CliException.failed(String.format(
                Locale.ROOT,
                "the error is about %.4g and may be %.4g, more than --error %s; decided by %s%s%s",
                Math.hypot(sampling.estimatedError(), sampling.rounding()),
                sampling.errorInFile(),
                DecimalNumber.plain(asked),
                report.decidedBy(),
                samples.isPresent() ? "; try --samples " + DecimalNumber.plain(samples.getAsDouble()) + " or more" : "",
                rounding(sampling, asked)));
    }

    /** The part of the message about the file's rounding, if that matters. */
    private static String rounding(RenderReport.Sampling sampling, double asked) {
        if (sampling.rounding() >= asked) {
            return String.format(
                    Locale.ROOT,
                    "; the file's rounding alone makes %.3g of it, whatever the samples: --depth 16 or a .pfm file has less",
                    sampling.rounding());
        }
        return 2 * sampling.rounding() > sampling.errorInFile()
                ? "; much of it is the file's rounding: --depth 16 or a .pfm file has less"
                : "";
    }
}
