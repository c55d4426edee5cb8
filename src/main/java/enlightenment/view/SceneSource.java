package enlightenment.view;

import enlightenment.scene.Scene;
import enlightenment.scene.SceneException;
import java.nio.file.Path;
import java.util.OptionalInt;

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

    /**
     * Reads a frame of the file's animation, with what it has in common with the frame that was read before.
     *
     * @param frame counted from 0
     * @throws SceneException if it cannot be read or used, with all problems and their places
     */
    Scene read(int frame);

    /** The frame that {@link #read()} gives, counted from 0; empty if that is the scene as its file's own numbers say. */
    OptionalInt frame();

    /** Adds file and line to problems without any: those that are found only when a scene is rendered. */
    SceneException located(SceneException e);
}
