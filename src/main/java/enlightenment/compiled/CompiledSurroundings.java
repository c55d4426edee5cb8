package enlightenment.compiled;

import enlightenment.material.Texture;
import enlightenment.scene.Background;
import enlightenment.scene.SceneException;
import enlightenment.surroundings.Surroundings;
import java.io.IOException;
import java.nio.file.Path;
import java.util.function.Function;

/** What a background becomes. */
final class CompiledSurroundings {
    private CompiledSurroundings() {}

    /**
     * Null if the same light comes from everywhere.
     *
     * @param files returns the content of an image file, or null if it must be read from the disk
     */
    static Surroundings of(Background background, Function<Path, byte[]> files) {
        if (background instanceof Background.Picture p) {
            return picture(p, files.apply(p.picture().file()));
        }
        if (background instanceof Background.Sky s) {
            return Surroundings.sky(
                    s.elevation(), s.azimuth(), s.turbidity(), s.groundAlbedo(), s.hasSun(), s.radiance());
        }
        return null;
    }

    private static Surroundings picture(Background.Picture p, byte[] content) {
        boolean isLight = p.picture().encoding() == Texture.Encoding.LINEAR;
        try {
            return content == null
                    ? Surroundings.read(p.picture().file(), p.radiance(), p.rotation(), isLight)
                    : Surroundings.of(content, p.radiance(), p.rotation(), isLight);
        } catch (IOException e) {
            String problem = content == null
                    ? e.getMessage()
                    : "cannot read " + p.picture().file() + ": " + e.getMessage();
            throw SceneException.of("/shading/background/texture", problem);
        }
    }
}
