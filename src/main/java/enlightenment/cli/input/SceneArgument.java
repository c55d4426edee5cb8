package enlightenment.cli.input;

import enlightenment.cli.terminal.Terminal;
import java.nio.file.Path;
import picocli.CommandLine.Parameters;

/** The scene that a command is given. */
public final class SceneArgument {
    @Parameters(paramLabel = "SCENE", description = "the scene file; - for standard input")
    private Path file;

    public SceneArgument() {}

    public Path file() {
        return file;
    }

    /** The input that the argument names. */
    public SceneInput open(Terminal terminal) {
        return new SceneInput(file, terminal);
    }

    /** The input that the argument names, with the options for files of other programs. */
    public SceneInput open(ForeignOptions foreign, Terminal terminal) {
        foreign.check();
        return new SceneInput(file, foreign, terminal);
    }
}
