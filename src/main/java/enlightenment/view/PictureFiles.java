package enlightenment.view;

import enlightenment.image.ImageFormat;
import enlightenment.render.RenderResult;
import enlightenment.scene.Scene;
import java.io.IOException;
import java.util.OptionalInt;

/** Encoder of finished pictures. */
@FunctionalInterface
public interface PictureFiles {
    /**
     * The bytes of a picture's file, as the command {@code render} writes it for the same settings.
     *
     * @param scene the scene that was rendered
     * @param frame the animation frame, counted from 0; empty if no track has been applied
     * @param result a complete picture, with its settings
     * @param format a format that the program can write
     */
    byte[] bytes(Scene scene, OptionalInt frame, RenderResult result, ImageFormat format) throws IOException;
}
