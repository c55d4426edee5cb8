package enlightenment.view;

import enlightenment.scene.Scene;
import enlightenment.scene.SceneException;
import java.nio.file.Path;
import java.util.OptionalInt;

/** The scene file of a view, and how it is read. */
public interface SceneSource {
    /** The scene file, which the view watches. */
    Path file();

    /** Whether the file is in the scene format of this program, so that a camera can be written into it. */
    boolean isNative();

    /**
     * Reads the file as it is now.
     *
     * @throws SceneException if the file cannot be read or used, with all problems and their places
     */
    Scene read();

    /**
     * Reads a frame of the file's animation; meshes are shared with the last read.
     *
     * @param frame counted from 0
     * @throws SceneException if the file cannot be read or used, with all problems and their places
     */
    Scene read(int frame);

    /** The animation frame that {@link #read()} returns, counted from 0; empty if it applies no track. */
    OptionalInt frame();

    /** Adds file and line to problems without a place, such as those that are found only by rendering. */
    SceneException located(SceneException e);
}
