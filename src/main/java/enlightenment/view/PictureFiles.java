package enlightenment.view;

import enlightenment.image.ImageFormat;
import enlightenment.render.RenderResult;
import enlightenment.scene.Scene;
import java.io.IOException;
import java.util.OptionalInt;

/** How finished pictures become files. */
@FunctionalInterface
public interface PictureFiles {
    /**
     * The file of a picture, as the command {@code render} writes it for the same settings.
     *
     * @param scene that was rendered
     * @param frame of its animation that it shows, counted from 0; empty if it was read as its own numbers say
     * @param result a whole picture, with its settings
     * @param format a format that is written
     */
    byte[] bytes(Scene scene, OptionalInt frame, RenderResult result, ImageFormat format) throws IOException;
}
