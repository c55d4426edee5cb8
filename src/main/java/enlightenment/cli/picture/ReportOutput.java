package enlightenment.cli.picture;

import enlightenment.cli.option.CommandFiles;
import enlightenment.cli.terminal.Terminal;
import enlightenment.file.WholeFile;
import enlightenment.net.RenderServer;
import enlightenment.render.RenderResult;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Path;
import java.util.Optional;
import picocli.CommandLine.Option;

/** The options that tell what a render did. */
public final class ReportOutput {
    @Option(names = "--report", paramLabel = "FILE", description = "write the render's statistics to this JSON file")
    private Path report;

    @Option(names = "--stats", description = "print the render's statistics")
    private boolean stats;

    public ReportOutput() {}

    /** Adds the file that will be written, if any. */
    public void register(CommandFiles files) {
        files.writes("--report", report);
    }

    /** Writes and prints what was asked for; where the picture goes to standard output, the statistics go elsewhere. */
    public void write(RenderResult result, PictureOutput picture, Terminal terminal) throws IOException {
        write(result, Optional.empty(), Optional.empty(), picture, terminal);
    }

    /**
     * Does so for a picture whose method may have been chosen by the program, or that a server made.
     *
     * @param reason why that method; empty if the settings named it
     * @param audits those of a server
     */
    public void write(
            RenderResult result,
            Optional<String> reason,
            Optional<RenderServer.AuditReport> audits,
            PictureOutput picture,
            Terminal terminal)
            throws IOException {
        if (report != null) {
            WholeFile.write(report, ReportJson.of(result, reason, audits));
        }
        if (stats) {
            PrintStream stream = picture.isStandardOutput() ? terminal.err() : terminal.out();
            stream.print(StatsTable.of(result.report()));
        }
    }
}
