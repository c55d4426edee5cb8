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

    /** Where to read the scene from. */
    public SceneInput open(Terminal terminal) {
        return new SceneInput(file, terminal);
    }

    /** Where to read the scene from, with the choices for a file of another program. */
    public SceneInput open(ForeignOptions foreign, Terminal terminal) {
        foreign.check();
        return new SceneInput(file, foreign, terminal);
    }
}
