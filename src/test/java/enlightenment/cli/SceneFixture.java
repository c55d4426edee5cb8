package enlightenment.cli;

import java.io.IOException;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.io.TempDir;

/** For tests of commands: a small scene in a folder of its own, and where its picture goes. */
abstract class SceneFixture {
    private final String size;

    @TempDir
    Path folder;

    Path scene;
    Path picture;

    SceneFixture(int width, int height) {
        size = "\"width\": " + width + ", \"height\": " + height;
    }

    @BeforeEach
    void writeScene() throws IOException {
        scene = CliRun.scene(folder, size);
        picture = folder.resolve("p.png");
    }
}
