package enlightenment.cli.picture;

import enlightenment.cli.option.CommandFiles;
import enlightenment.cli.terminal.CliException;
import enlightenment.cli.terminal.Terminal;
import enlightenment.image.Image;
import enlightenment.picture.Rounding;
import enlightenment.render.RenderRequest;
import enlightenment.render.RenderResult;
import java.io.IOException;
import java.util.Map;
import java.util.Optional;
import picocli.CommandLine.Mixin;

/** The options of commands that make a picture of results which are there, and what they do with it. */
public final class ResultPicture {
    @Mixin
    private PictureOutput output = new PictureOutput();

    @Mixin
    private ViewOption view = new ViewOption();

    @Mixin
    private ReportOutput report = new ReportOutput();

    public ResultPicture() {}

    /** The name of the output in messages. */
    public String name() {
        return output.name();
    }

    /** The folder for a picture too large for the memory; empty if it must be in memory. */
    public Optional<RenderRequest.ScratchFolder> scratch() {
        return output.scratch();
    }

    /** Fails if it cannot be written so, or not beside these files, which are read. */
    public void check(CommandFiles files) throws IOException {
        output.check();
        view.check(output);
        files.writes("-o", output.file());
        report.register(files);
        files.check();
    }

    /**
     * Writes it, with its report, and fails if it is not as it was asked for.
     *
     * @param texts what its file says of itself
     * @param missing what is missing in it, in words; {@code ""} for nothing
     */
    public void write(RenderResult made, Map<String, String> texts, String missing, Terminal terminal)
            throws IOException {
        output.check(made.report().settings());
        RenderResult result = made.withRounding(Rounding.of(made.image(), output.writtenDepth()));
        Image shown = view.view(result.image(), terminal);
        output.write(shown, texts, made.report().settings(), terminal);
        report.write(result, output, terminal);
        if (!missing.isEmpty()) {
            throw CliException.failed(missing);
        }
        output.tellBrightness(result, shown, terminal);
        LightNotes.tell(result, terminal::say);
        LightNotes.require(result, shown);
        RequestedError.require(result);
    }
}
