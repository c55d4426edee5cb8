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
 * The image files of scenes, each read once for the lifetime of this object, and the tables of their materials: shared by the frames of a
 * film. A file that changes meanwhile is not read again.
 */
public final class SceneImages {
    private final Function<Path, byte[]> files;
    private final Map<Key, ImageTexture> images = new HashMap<>();

    private final Map<Path, IntensityTable> tables = new HashMap<>();

    /** The last surroundings, and the background that they were made from. */
    private Surroundings surroundings;

    private Shading.Background background;

    /** The scattering functions of the last scene's materials. */
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
     * The image in a file.
     *
     * @param isPhysical whether its texels become linear light
     * @param scene in which the texture has its name
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
     * The image in a file, as {@link #of(Texture.File, boolean, Scene)}.
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
     * The intensity table in a file, kept as images are.
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

    /** Whether any image has been read. */
    public synchronized boolean haveBeenRead() {
        return !images.isEmpty();
    }

    /**
     * The compiled surroundings of a background; null if their radiance is constant. The last ones are kept.
     *
     * @throws SceneException if the file of a picture cannot be used
     */
    public synchronized Surroundings around(Shading.Background of) {
        if (background == null || !of.equals(background)) {
            surroundings = CompiledSurroundings.of(of, files);
            background = of;
        }
        return surroundings;
    }

    /** The scattering functions for the materials of the next scene, which reuse those of the last one. */
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
