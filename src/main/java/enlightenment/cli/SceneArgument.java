package enlightenment.cli;

import java.nio.file.Path;
import picocli.CommandLine.Parameters;

/** The scene that a command is given. */
final class SceneArgument {
    @Parameters(paramLabel = "SCENE", description = "the scene file; - for standard input")
    private Path file;

    SceneArgument() {}

    Path file() {
        return file;
    }

    /** Where to read the scene from. */
    SceneInput open(Terminal terminal) {
        return new SceneInput(file, terminal);
    }
}
