package enlightenment.view;

import enlightenment.image.Image;
import enlightenment.image.ImageFiles;
import enlightenment.image.ImageFormat;
import enlightenment.scene.Scene;
import enlightenment.scene.SceneException;
import enlightenment.scene.json.SceneReader;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.Path;
import java.util.OptionalInt;

/**
 * A scene file for views, read by the reader of scenes.
 *
 * @param isNative whether it is to pass for a file of this program
 */
record FileSource(Path file, boolean isNative) implements SceneSource {
    /** The files of final renders without what {@code render} writes into them beside the picture. */
    static final PictureFiles FILES = (scene, frame, result, format) -> bytes(result.image(), format);

    static byte[] bytes(Image image, ImageFormat format) throws IOException {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        ImageFiles.write(image, out, format, ImageFiles.PngOptions.DEFAULT);
        return out.toByteArray();
    }

    FileSource(Path file) {
        this(file, true);
    }

    @Override
    public Scene read() {
        return SceneReader.read(file);
    }

    @Override
    public Scene read(int frame) {
        return SceneReader.read(file, frame);
    }

    @Override
    public OptionalInt frame() {
        return OptionalInt.empty();
    }

    @Override
    public SceneException located(SceneException e) {
        return SceneReader.located(e, file);
    }
}
