package enlightenment.measure;

import enlightenment.color.Color;
import enlightenment.color.DisplayCurve;
import enlightenment.image.Image;
import enlightenment.image.ImageFiles;
import enlightenment.image.ImageFormat;
import enlightenment.scene.Scene;
import enlightenment.scene.Shading;
import java.io.IOException;
import java.nio.file.Path;

/** Reader of a scene's pictures. With physical shading, a float map has linear light and gets the scene's display curve. */
final class StoredPicture {
    private StoredPicture() {}

    static Image read(Scene scene, Path file) throws IOException {
        boolean isFloats =
                ImageFormat.ofExtension(file).filter(ImageFormat::holdsFloats).isPresent();
        if (!isFloats || !(scene.shading() instanceof Shading.Physical)) {
            return ImageFiles.read(file);
        }
        return ImageFiles.read(file, Color.Encoding.LINEAR)
                .withCurve(DisplayCurve.of(
                        scene.display().exposure(), scene.display().tone()));
    }
}
