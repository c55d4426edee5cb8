package enlightenment.cli.scene;

import enlightenment.cli.input.ForeignOptions;
import enlightenment.cli.input.ForeignScene;
import enlightenment.cli.option.CommandFiles;
import enlightenment.cli.option.FileNames;
import enlightenment.cli.option.Subcommand;
import enlightenment.cli.terminal.CliException;
import enlightenment.cli.terminal.ExitCode;
import enlightenment.cli.terminal.StandardStreams;
import enlightenment.cli.terminal.Terminal;
import enlightenment.importer.SceneImporter;
import enlightenment.nff.NffReader;
import enlightenment.scene.json.SceneWriter;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code enlightenment convert}: converts a file of another program to a scene file. */
@Command(
        name = "convert",
        description =
                "Converts a scene or a model of another program to a scene file. Notes on standard error say what is left out.")
public final class ConvertCommand extends Subcommand {
    @Parameters(
            index = "0",
            paramLabel = "IN",
            description = "the file to read: "
                    + "Mitsuba's XML, pbrt-v4, glTF, PLY, OBJ, STL, Mitsuba's serialized, NFF; "
                    + "- for an NFF file from standard input")
    private Path input;

    @Parameters(
            index = "1",
            arity = "0..1",
            paramLabel = "OUT.json",
            description = "the scene file to write; - for standard output")
    private Path second;

    @Option(
            names = {"-o", "--output"},
            paramLabel = "FILE",
            description = "the same, as other commands have it; in place of OUT.json")
    private Path option;

    @Option(names = "--strict", description = "fail if anything is left out or approximated")
    private boolean isStrict;

    @Mixin
    private ForeignOptions foreign = new ForeignOptions();

    @Spec
    private CommandSpec spec;

    public ConvertCommand(Terminal terminal) {
        super(terminal);
    }

    @Override
    protected int execute() throws IOException {
        foreign.check();
        Path output = output();
        if (!StandardStreams.isNamed(output) && !FileNames.extension(output).equals(".json")) {
            throw CliException.wrongUsage("OUT.json must name a file that ends in .json, not \"" + output + "\"");
        }
        if (!StandardStreams.isNamed(input) && !Files.exists(input)) {
            throw CliException.wrongUsage(input + ": there is no such file");
        }
        new CommandFiles()
                .reads("IN", input)
                .writes(option == null ? "OUT.json" : "-o", output)
                .check();
        ConvertedFiles files = new ConvertedFiles(output);
        SceneImporter.Result result = read(files);
        for (String note : result.notes()) {
            terminal.note((StandardStreams.isNamed(input) ? StandardStreams.INPUT : input) + ": " + note);
        }
        if (isStrict && !result.notes().isEmpty()) {
            throw CliException.wrongUsage("with --strict nothing is written: the file says "
                    + (result.notes().size() == 1 ? "something" : "things") + " that the scene would not");
        }
        if (StandardStreams.isNamed(output)) {
            files.refuseMeshes(result.scene());
            terminal.out().write(SceneWriter.toJson(result.scene(), Path.of("")).getBytes(StandardCharsets.UTF_8));
        } else {
            files.write(result.scene());
        }
        return ExitCode.DONE;
    }

    private Path output() {
        if (option == null && second == null) {
            throw new ParameterException(spec.commandLine(), "missing: -o FILE, or OUT.json after the file to read");
        }
        if (option != null && second != null) {
            throw new ParameterException(
                    spec.commandLine(), "-o and OUT.json name a file to write each; one of them is needed");
        }
        return option == null ? second : option;
    }

    private SceneImporter.Result read(ConvertedFiles files) {
        if (StandardStreams.isNamed(input)) {
            foreign.refuse(StandardStreams.INPUT);
            // The format is ASCII; comments may hold anything.
            NffReader.Result nff = NffReader.parse(
                    new String(StandardStreams.readInput(terminal), StandardCharsets.ISO_8859_1),
                    StandardStreams.INPUT,
                    "");
            return new SceneImporter.Result(nff.scene(), nff.notes());
        }
        return ForeignScene.read(input, files.options(foreign.options()));
    }
}
