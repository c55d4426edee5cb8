package enlightenment.net.job;

import enlightenment.engine.RenderOutline;
import enlightenment.file.ContentHash;
import enlightenment.image.Image;
import enlightenment.image.ImageFiles;
import enlightenment.image.ImageFormat;
import enlightenment.image.PngOptions;
import enlightenment.net.protocol.Limits;
import enlightenment.plan.RenderPlan;
import enlightenment.scene.Animation;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.SceneException;
import enlightenment.scene.json.SceneReader;
import enlightenment.scene.json.SceneWriter;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;

/**
 * A job as contents that are addressed by their hashes. The first is the job's document: build, settings, plan, the kinds of
 * primitives that tiles count (for clients that do not read scenes), the number of the scene's instants, these, each with its length
 * before it, and the scene, in which image files are named by their hashes too; so its hash is the hash of everything that decides bits. The others are the image files.
 *
 * <p>Files of whole numbers that are not PNG travel as PNG files of the same texels: two JDKs may decode the same JPEG file
 * differently.
 */
public final class JobContent {
    private static final String MAGIC = "enlightenment job 4";
    private final Map<ContentHash, byte[]> contents;

    JobContent(Map<ContentHash, byte[]> contents) {
        this.contents = contents;
    }

    /**
     * The job of rendering this scene.
     *
     * @throws SceneException if an image file cannot be read or the scene cannot be written down
     * @throws IllegalArgumentException if the job is larger than {@link Limits#JOB}
     */
    public static JobContent of(Scene scene, RenderOutline outline, String build) {
        Map<Path, ContentHash> byPath = new LinkedHashMap<>();
        Map<ContentHash, byte[]> images = new LinkedHashMap<>();
        Function<Path, String> names =
                file -> byPath.computeIfAbsent(file, f -> add(images, read(f))).toString();
        Map<ContentHash, byte[]> all = new LinkedHashMap<>();
        add(all, document(outline, build, scenes(scene, names)));
        all.putAll(images);
        long bytes = all.values().stream().mapToLong(b -> b.length).sum();
        if (bytes > Limits.JOB || all.size() > Limits.CONTENTS) {
            throw new IllegalArgumentException("scene and textures have " + bytes + " bytes in " + all.size()
                    + " pieces; at most " + Limits.JOB + " in " + Limits.CONTENTS + " can be sent");
        }
        return new JobContent(all);
    }

    /** The job of rendering the same scene by another plan. */
    public JobContent with(RenderOutline outline, String build) {
        Map<ContentHash, byte[]> all = new LinkedHashMap<>();
        try (DataInputStream in = new DataInputStream(new ByteArrayInputStream(contents.get(hash())))) {
            in.readUTF();
            in.readUTF();
            SettingsBytes.read(in, 1);
            SettingsBytes.readTexts(in);
            add(all, document(outline, build, in.readAllBytes()));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        hashes().stream().skip(1).forEach(image -> all.put(image, content(image)));
        return new JobContent(all);
    }

    static ContentHash add(Map<ContentHash, byte[]> contents, byte[] content) {
        ContentHash hash = ContentHash.of(content);
        contents.put(hash, content);
        return hash;
    }

    static byte[] read(Path file) {
        try {
            byte[] bytes = Files.readAllBytes(file);
            Optional<ImageFormat> format = ImageFormat.ofContent(bytes);
            if (format.isPresent()
                    && (format.get() == ImageFormat.PNG || format.get().holdsFloats())) {
                return bytes;
            }
            Image image = ImageFiles.read(file);
            ByteArrayOutputStream png = new ByteArrayOutputStream();
            ImageFiles.toPng(image, png, PngOptions.DEFAULT);
            return png.toByteArray();
        } catch (IOException e) {
            throw new SceneException(List.of(new SceneException.Problem(
                    file.toString(), 0, 0, "", "the texture cannot be used: " + e.getMessage())));
        }
    }

    /** A scene's instants, then itself. */
    static byte[] scenes(Scene scene, Function<Path, String> names) {
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

    private static byte[] json(Scene scene, Function<Path, String> names) {
        return SceneWriter.toJson(scene.withoutAnimation(), names).getBytes(StandardCharsets.UTF_8);
    }

    private static Scene readScenes(DataInputStream in, Set<String> names) throws IOException {
        int count = in.readInt();
        if (count < 0 || count > Animation.MOST_INSTANTS) {
            throw new IOException("the job has " + count + " instants");
        }
        List<Scene> instants = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            int length = in.readInt();
            if (length < 0 || length > in.available()) {
                throw new IOException("the job ends too early");
            }
            instants.add(readScene(in.readNBytes(length), names));
        }
        return readScene(in.readAllBytes(), names).withInstants(instants);
    }

    private static Scene readScene(byte[] json, Set<String> names) {
        return SceneReader.readNamed(new String(json, StandardCharsets.UTF_8), names, "the server's scene");
    }

    static byte[] document(RenderOutline outline, String build, byte[] scenes) {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (DataOutputStream out = new DataOutputStream(bytes)) {
            out.writeUTF(MAGIC);
            out.writeUTF(build);
            SettingsBytes.write(out, outline.settings(), outline.plan());
            SettingsBytes.write(out, outline.kinds());
            out.write(scenes);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return bytes.toByteArray();
    }

    /** The hash of the job. */
    public ContentHash hash() {
        return contents.keySet().iterator().next();
    }

    /** The hashes of all contents, the job's own first. */
    public List<ContentHash> hashes() {
        return new ArrayList<>(contents.keySet());
    }

    /** The content of this hash, or null. */
    public byte[] content(ContentHash hash) {
        return contents.get(hash);
    }

    /** What a job's document says. */
    public record Document(Scene scene, RenderSettings settings, RenderPlan plan) {}

    /**
     * Reads a job's document.
     *
     * @param images the hashes of the image files that there are
     * @param threads what the settings are to say of threads
     * @throws IOException if it makes no sense; the message says why
     */
    public static Document read(byte[] document, Collection<ContentHash> images, String build, int threads)
            throws IOException {
        ByteArrayInputStream bytes = new ByteArrayInputStream(document);
        try (DataInputStream in = new DataInputStream(bytes)) {
            if (!in.readUTF().equals(MAGIC)) {
                throw new IOException("this is no job");
            }
            String theirs = in.readUTF();
            if (!theirs.equals(build)) {
                throw new IOException("the job is of version " + theirs + ", this is " + build);
            }
            SettingsBytes.Decided decided = SettingsBytes.read(in, threads);
            SettingsBytes.readTexts(in);
            Set<String> names = Set.copyOf(
                    images.stream().map(ContentHash::toString).distinct().toList());
            return new Document(readScenes(in, names), decided.settings(), decided.plan());
        } catch (IllegalArgumentException | SceneException e) {
            throw new IOException("the job cannot be used: " + e.getMessage(), e);
        }
    }
}
