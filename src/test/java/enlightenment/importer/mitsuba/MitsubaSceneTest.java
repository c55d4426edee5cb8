package enlightenment.importer.mitsuba;

import java.nio.file.Path;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.io.TempDir;

/** The base of tests that write scenes of Mitsuba into a folder of their own and read them. */
abstract class MitsubaSceneTest {
    @TempDir
    Path folder;

    MitsubaScenes scenes;

    @BeforeEach
    void makeScenes() {
        scenes = new MitsubaScenes(folder);
    }
}
