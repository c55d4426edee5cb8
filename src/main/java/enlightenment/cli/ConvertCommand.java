package enlightenment.cli;

import enlightenment.nff.NffReader;
import enlightenment.scene.json.SceneWriter;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import picocli.CommandLine.Command;
import picocli.CommandLine.Parameters;

/** {@code enlightenment convert}: makes a scene file of an NFF file. */
@Command(name = "convert", description = "Makes a scene file of a file in the Neutral File Format.")
final class ConvertCommand extends Subcommand {
    @Parameters(index = "0", paramLabel = "IN.nff", description = "the file to read")
    private Path input;

    @Parameters(index = "1", paramLabel = "OUT.json", description = "the scene file to write")
    private Path output;

    ConvertCommand(Terminal terminal) {
        super(terminal);
    }

    @Override
    int execute() throws IOException {
        if (!Target.extension(output).equals(".json")) {
            throw CliException.wrongUsage("OUT.json must name a file that ends in .json, not \"" + output + "\"");
        }
        if (!Files.exists(input)) {
            throw CliException.wrongUsage(input + ": there is no such file");
        }
        if (Target.same(input, output)) {
            throw CliException.wrongUsage("OUT.json must name another file than IN.nff, not \"" + output + "\"");
        }
        Target.check(output);
        NffReader.Result result = NffReader.read(input);
        for (String note : result.notes()) {
            terminal.note(input + ": " + note);
        }
        SceneWriter.write(result.scene(), output);
        return CliException.DONE;
    }
}
