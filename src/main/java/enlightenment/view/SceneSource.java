package enlightenment.view;

import enlightenment.scene.Scene;
import enlightenment.scene.SceneException;
import java.nio.file.Path;

/** Where the scene of a view comes from. */
public interface SceneSource {
    /** The file that is looked at. */
    Path file();

    /** Whether it is a scene file, into which a camera can be written; others are files of other programs. */
    boolean isNative();

    /**
     * Reads the file as it is now.
     *
     * @throws SceneException if it cannot be read or used, with all problems and their places
     */
    Scene read();

    /** Adds file and line to problems without any: those that are found only when a scene is rendered. */
    SceneException located(SceneException e);
}
