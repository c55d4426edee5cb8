package enlightenment.world.light;

import enlightenment.light.Light;
import enlightenment.material.Texture;
import enlightenment.photometry.IesFile;
import enlightenment.photometry.IntensityTable;
import enlightenment.scene.Scene;
import enlightenment.scene.SceneException;
import enlightenment.scene.Shading;
import enlightenment.surroundings.Surroundings;
import enlightenment.texture.ImageTexture;
import enlightenment.world.material.MaterialBsdfs;
import java.io.IOException;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import java.util.function.Function;

/**
 * The image files of scenes, each read once, for as long as this is kept, and the tables of their materials: what the frames of a film have
 * in common. A file that changes meanwhile is not read again.
 */
public final class SceneImages {
    private final Function<Path, byte[]> files;
    private final Map<Key, ImageTexture> images = new HashMap<>();

    private final Map<Path, IntensityTable> tables = new HashMap<>();

    /** The last surroundings, and what they were made of. */
    private Surroundings surroundings;

    private Shading.Background background;

    /** Those of the last scene. */
    private MaterialBsdfs bsdfs = new MaterialBsdfs();

    private record Key(Path file, Texture.Encoding encoding, boolean isPhysical) {}

    /** Reads the files from the disk. */
    public SceneImages() {
        this(path -> null);
    }

    /** @param files returns the content of an image file, or null if it must be read from the disk */
    public SceneImages(Function<Path, byte[]> files) {
        this.files = files;
    }

    /**
     * The picture in a file.
     *
     * @param isPhysical whether its texels become light
     * @param scene where the texture has its name
     * @throws SceneException if the file cannot be used
     */
    public ImageTexture of(Texture.File texture, boolean isPhysical, Scene scene) {
        try {
            return read(texture, isPhysical);
        } catch (IOException e) {
            throw SceneException.ofTexture(scene, texture.file(), e.getMessage());
        }
    }

    /**
     * As {@link #of}.
     *
     * @throws IOException if the file cannot be used; the message names it
     */
    public synchronized ImageTexture read(Texture.File texture, boolean isPhysical) throws IOException {
        Key key = new Key(texture.file(), texture.encoding(), isPhysical);
        ImageTexture image = images.get(key);
        if (image == null) {
            ImageTexture loaded = load(texture, files.apply(texture.file()));
            image = isPhysical ? loaded.decoded() : loaded;
            images.put(key, image);
        }
        return image;
    }

    /**
     * The intensities in a file, which are kept as images are.
     *
     * @param index of the light among the scene's
     * @throws SceneException at the place of the light, if the file cannot be used
     */
    synchronized IntensityTable of(Light.Ies light, int index) {
        IntensityTable table = tables.get(light.file());
        if (table == null) {
            byte[] content = files.apply(light.file());
            try {
                table = content == null ? IesFile.read(light.file()) : IesFile.of(content);
            } catch (IOException e) {
                throw SceneException.of(
                        "/lights/" + index + "/file",
                        content == null ? e.getMessage() : "cannot read " + light.file() + ": " + e.getMessage());
            }
            tables.put(light.file(), table);
        }
        return table;
    }

    /** Whether there is any already. */
    public synchronized boolean haveBeenRead() {
        return !images.isEmpty();
    }

    /**
     * What a background becomes; null if the same light comes from everywhere. The last one is kept.
     *
     * @throws SceneException if the file of a picture cannot be used
     */
    public synchronized Surroundings around(Shading.Background of) {
        if (!of.equals(background)) {
            surroundings = CompiledSurroundings.of(of, files);
            background = of;
        }
        return surroundings;
    }

    /** How the materials of the next scene scatter light: what the last one has in common with it is not made again. */
    public synchronized MaterialBsdfs bsdfs() {
        bsdfs = bsdfs.next();
        return bsdfs;
    }

    private static ImageTexture load(Texture.File texture, byte[] content) throws IOException {
        if (content != null) {
            return ImageTexture.of(content, texture.encoding() == Texture.Encoding.LINEAR);
        }
        return texture.encoding() == Texture.Encoding.LINEAR
                ? ImageTexture.readLinear(texture.file())
                : ImageTexture.read(texture.file());
    }
}
