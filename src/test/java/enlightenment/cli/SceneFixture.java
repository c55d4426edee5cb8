package enlightenment.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.io.TempDir;

/** For tests of commands: a small scene in a folder of its own, and where its picture goes. */
public abstract class SceneFixture {
    private final String size;

    @TempDir
    protected Path folder;

    protected Path scene;
    protected Path picture;

    protected SceneFixture(int width, int height) {
        size = "\"width\": " + width + ", \"height\": " + height;
    }

    @BeforeEach
    void writeScene() throws IOException {
        scene = CliRun.scene(folder, size);
        picture = folder.resolve("p.png");
    }

    /** The words of a command that makes the picture of the scene, with these after them. */
    protected Object[] words(String command, Object... more) {
        return Stream.concat(Stream.of(command, scene, "-o", picture), Stream.of(more))
                .toArray();
    }

    protected CliRun render(Object... more) {
        return CliRun.of(words("render", more));
    }
}
