package enlightenment.engine;

import enlightenment.world.light.SceneImages;
import java.nio.file.Path;
import java.util.function.Function;

/** The image files of several scenes, each read and decoded once. */
public final class SharedImages {
    final SceneImages images;

    /** Reads the files from the disk. */
    public SharedImages() {
        images = new SceneImages();
    }

    /** @param files gives the content of an image file, or null if it is to be read from the disk */
    public SharedImages(Function<Path, byte[]> files) {
        images = new SceneImages(files);
    }
}
