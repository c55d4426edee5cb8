package enlightenment.job;

import enlightenment.file.ContentHash;
import enlightenment.file.FileFailure;
import enlightenment.file.InputFile;
import enlightenment.image.Image;
import enlightenment.image.ImageFiles;
import enlightenment.image.ImageFormat;
import enlightenment.mesh.MeshFiles;
import enlightenment.mesh.TriangleMesh;
import enlightenment.scene.Scene;
import enlightenment.scene.SceneException;
import enlightenment.scene.json.SceneWriter;
import java.io.ByteArrayOutputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * A scene as bytes, in which image files are named by the hashes of their contents: the number of the scene's instants, these, each with
 * its length before it, and the scene. So their hash tells the scene from all others, wherever its files lie.
 *
 * <p>Files of whole numbers that are not PNG are kept as PNG files of the same texels: two JDKs may decode the same JPEG file
 * differently.
 */
public final class SceneDocument {
    private final byte[] bytes;
    private final Map<ContentHash, byte[]> images;

    private SceneDocument(byte[] bytes, Map<ContentHash, byte[]> images) {
        this.bytes = bytes;
        this.images = Collections.unmodifiableMap(images);
    }

    /**
     * The document of a scene.
     *
     * @throws SceneException if an image file cannot be read or the scene cannot be written down
     */
    public static SceneDocument of(Scene scene) {
        return of(scene, new Images());
    }

    /**
     * The document of one of several scenes.
     *
     * @param shared their image files, each read once; has those of this scene from now on
     * @throws SceneException if an image file cannot be read or the scene cannot be written down
     */
    public static SceneDocument of(Scene scene, Images shared) {
        return new SceneDocument(scenes(scene, shared.of(scene)), shared.contents);
    }

    /** The files of several scenes: images, and meshes as PLY files of just their numbers, whatever they were read from. */
    public static final class Images {
        private final Map<TriangleMesh, ContentHash> byMesh = new LinkedHashMap<>();
        private final Map<Path, ContentHash> byPath = new LinkedHashMap<>();
        private final Map<ContentHash, byte[]> contents = new LinkedHashMap<>();

        private String name(Path file, Scene scene) {
            return byPath.computeIfAbsent(file, f -> {
                        byte[] content = read(f, scene);
                        ContentHash hash = ContentHash.of(content);
                        contents.put(hash, content);
                        return hash;
                    })
                    .toString();
        }

        private SceneWriter.FileNames of(Scene scene) {
            return new SceneWriter.FileNames() {
                @Override
                public String of(Path file) {
                    return name(file, scene);
                }

                @Override
                public Optional<String> of(TriangleMesh mesh) {
                    return Optional.of(name(mesh));
                }
            };
        }

        private String name(TriangleMesh mesh) {
            return byMesh.computeIfAbsent(mesh, m -> {
                        byte[] content = ply(m);
                        ContentHash hash = ContentHash.of(content);
                        contents.put(hash, content);
                        return hash;
                    })
                    .toString();
        }

        /** Their contents, by their hashes. */
        public Map<ContentHash, byte[]> contents() {
            return Collections.unmodifiableMap(contents);
        }
    }

    private static byte[] ply(TriangleMesh mesh) {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try {
            MeshFiles.writePly(mesh, bytes);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return bytes.toByteArray();
    }

    private static byte[] read(Path file, Scene scene) {
        int light = scene.lightOf(file);
        if (light >= 0) {
            try {
                return InputFile.bytes(file);
            } catch (IOException e) {
                throw SceneException.of("/lights/" + light + "/file", FileFailure.described(e));
            }
        }
        try {
            byte[] bytes = InputFile.bytes(file);
            Optional<ImageFormat> format = ImageFormat.ofContent(bytes);
            if (format.isPresent()
                    && (format.get() == ImageFormat.PNG || format.get().holdsFloats())) {
                return bytes;
            }
            Image image = ImageFiles.read(file);
            ByteArrayOutputStream png = new ByteArrayOutputStream();
            ImageFiles.toPng(image, png, ImageFiles.PngOptions.DEFAULT);
            return png.toByteArray();
        } catch (IOException e) {
            throw SceneException.ofTexture(scene, file, e.getMessage());
        }
    }

    private static byte[] scenes(Scene scene, SceneWriter.FileNames names) {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (DataOutputStream out = new DataOutputStream(bytes)) {
            out.writeInt(scene.instants().size());
            for (Scene instant : scene.instants()) {
                byte[] json = json(instant, names);
                out.writeInt(json.length);
                out.write(json);
            }
            out.write(json(scene, names));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return bytes.toByteArray();
    }

    private static byte[] json(Scene scene, SceneWriter.FileNames names) {
        return SceneWriter.toJson(scene.withoutAnimation().withInstants(List.of()), names)
                .getBytes(StandardCharsets.UTF_8);
    }

    /** The bytes; not to be changed. */
    public byte[] bytes() {
        return bytes;
    }

    /** The contents of the image files, by their hashes. */
    public Map<ContentHash, byte[]> images() {
        return images;
    }

    /** What tells the scene and its image files from all others. */
    public ContentHash hash() {
        return ContentHash.of(bytes);
    }
}
