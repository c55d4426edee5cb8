package enlightenment.cli.scene;

import enlightenment.cli.option.CommandFiles;
import enlightenment.cli.option.FileNames;
import enlightenment.cli.option.Subcommand;
import enlightenment.cli.terminal.CliException;
import enlightenment.cli.terminal.ExitCode;
import enlightenment.cli.terminal.StandardStreams;
import enlightenment.cli.terminal.Terminal;
import enlightenment.file.FileFailure;
import enlightenment.nff.NffReader;
import enlightenment.scene.json.SceneWriter;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code enlightenment convert}: converts an NFF file to a scene file. */
@Command(name = "convert", description = "Converts a file in the Neutral File Format to a scene file.")
public final class ConvertCommand extends Subcommand {
    @Parameters(index = "0", paramLabel = "IN.nff", description = "the file to read; - for standard input")
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

    @Spec
    private CommandSpec spec;

    public ConvertCommand(Terminal terminal) {
        super(terminal);
    }

    @Override
    protected int execute() throws IOException {
        Path output = output();
        if (!StandardStreams.isNamed(output) && !FileNames.extension(output).equals(".json")) {
            throw CliException.wrongUsage("OUT.json must name a file that ends in .json, not \"" + output + "\"");
        }
        if (!StandardStreams.isNamed(input) && !Files.exists(input)) {
            throw CliException.wrongUsage(input + ": there is no such file");
        }
        new CommandFiles()
                .reads("IN.nff", input)
                .writes(option == null ? "OUT.json" : "-o", output)
                .check();
        NffReader.Result result = read();
        for (String note : result.notes()) {
            terminal.note((StandardStreams.isNamed(input) ? StandardStreams.INPUT : input) + ": " + note);
        }
        if (StandardStreams.isNamed(output)) {
            terminal.out().write(SceneWriter.toJson(result.scene(), Path.of("")).getBytes(StandardCharsets.UTF_8));
        } else {
            SceneWriter.write(result.scene(), output);
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

    private NffReader.Result read() throws IOException {
        return StandardStreams.isNamed(input)
                // The format is ASCII; comments may hold anything.
                ? NffReader.parse(
                        new String(StandardStreams.readInput(terminal), StandardCharsets.ISO_8859_1),
                        StandardStreams.INPUT,
                        "")
                : readFile();
    }

    /** What is no file to be converted is the user's mistake, as one that is missing is. */
    private NffReader.Result readFile() throws IOException {
        try {
            return NffReader.read(input);
        } catch (FileSystemException e) {
            throw CliException.wrongUsage(FileFailure.described(e));
        }
    }
}
