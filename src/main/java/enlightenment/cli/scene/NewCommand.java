package enlightenment.cli.scene;

import enlightenment.cli.option.CommandFiles;
import enlightenment.cli.option.FileNames;
import enlightenment.cli.option.Subcommand;
import enlightenment.cli.terminal.CliException;
import enlightenment.cli.terminal.ExitCode;
import enlightenment.cli.terminal.Shell;
import enlightenment.cli.terminal.StandardStreams;
import enlightenment.cli.terminal.Terminal;
import enlightenment.file.WholeFile;
import enlightenment.scene.json.SceneWriter;
import enlightenment.text.Plain;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code enlightenment new}: writes a scene file to begin with. */
@Command(name = "new", description = "Writes a scene file to begin with, whose comments explain what is in it.")
public final class NewCommand extends Subcommand {
    private static final String EXTENSION = ".json";
    private static final int LONGEST_LINE = 10_000;

    @Parameters(
            paramLabel = "NAME",
            description =
                    "the scene file to write, which must not be there yet; .json is added if there is no extension")
    private Path name;

    @Option(
            names = "--kind",
            paramLabel = "KIND",
            description = "what kind of scene: ${COMPLETION-CANDIDATES} (default: ${DEFAULT-VALUE})",
            converter = StarterKind.Words.class,
            completionCandidates = StarterKind.Words.class,
            defaultValue = "studio")
    private StarterKind kind;

    @Option(
            names = "--model",
            paramLabel = "FILE",
            description = "a PLY, OBJ, STL or Mitsuba .serialized file that stands in place of the main object")
    private Path model;

    public NewCommand(Terminal terminal) {
        super(terminal);
    }

    @Override
    protected int execute() throws IOException {
        Path file = file();
        if (Files.exists(file, LinkOption.NOFOLLOW_LINKS)) {
            throw CliException.wrongUsage(
                    Plain.quoted(file.toString()) + " is there already, and new replaces no file: choose another name");
        }
        if (model != null && !Files.exists(model)) {
            throw CliException.wrongUsage(model + ": there is no such file");
        }
        new CommandFiles().reads("--model", model).writes("NAME", file).check();
        WholeFile.write(file, text(file));
        terminal.show("wrote " + line(file.toString()));
        terminal.show("next: " + line(next(file)));
        return ExitCode.DONE;
    }

    /** The file to write: NAME, with its extension. */
    private Path file() {
        String extension = FileNames.extension(name);
        boolean isFile = !StandardStreams.isNamed(name) && name.getFileName() != null;
        if (!isFile || !extension.isEmpty() && !extension.equals(EXTENSION)) {
            throw CliException.wrongUsage(
                    "NAME must name a file that ends in .json, or that has no extension, not \"" + name + "\"");
        }
        return extension.isEmpty() ? name.resolveSibling(name.getFileName() + EXTENSION) : name;
    }

    private String text(Path file) {
        String stem = FileNames.stem(file);
        if (model == null) {
            return StarterScene.text(kind, stem);
        }
        String path = SceneWriter.relativeTo(file.toAbsolutePath().getParent()).of(model);
        if (path.startsWith("../") || Path.of(path).isAbsolute()) {
            terminal.say("the model is outside of the scene's folder: the scene names it as " + Plain.quoted(path)
                    + "; copy it beside the scene, and change \"file\" there, before the scene is moved");
        }
        return StarterScene.text(kind, stem, StarterModel.read(model), path);
    }

    private static String line(String text) {
        return Plain.line(text, LONGEST_LINE);
    }

    /** The command that renders the scene, for the user to copy. */
    private String next(Path file) {
        String picture = file.toString().substring(0, file.toString().length() - EXTENSION.length()) + ".png";
        return "enlightenment render " + Shell.quoted(file.toString()) + " -o " + Shell.quoted(picture);
    }
}
