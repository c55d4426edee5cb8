package enlightenment.net.job;

import enlightenment.engine.OutlineBytes;
import enlightenment.engine.RenderOutline;
import enlightenment.file.ContentHash;
import enlightenment.job.SceneDocument;
import enlightenment.net.protocol.Limits;
import enlightenment.plan.RenderPlan;
import enlightenment.scene.Animation;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.SceneException;
import enlightenment.scene.json.SceneReader;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.UTFDataFormatException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * A job as contents that are addressed by their hashes. The first is the job's document: build, settings, plan, the kinds of
 * primitives that tiles count (for clients that do not read scenes), the number of the scene's instants, these, each with its length
 * before it, and the scene, in which image files are named by their hashes too ({@link SceneDocument}); so its hash is the hash of
 * everything that decides bits. The others are the image files.
 */
public final class JobContent {
    private static final String MAGIC = "enlightenment job 4";
    private final Map<ContentHash, byte[]> contents;
    private final ContentHash scene;
    private final String build;

    JobContent(Map<ContentHash, byte[]> contents, ContentHash scene, String build) {
        this.contents = contents;
        this.scene = scene;
        this.build = build;
    }

    /**
     * The job of rendering this scene.
     *
     * @throws SceneException if an image file cannot be read or the scene cannot be written down
     * @throws IllegalArgumentException if the job is larger than {@link Limits#JOB}
     */
    public static JobContent of(Scene scene, RenderOutline outline, String build) {
        SceneDocument document = SceneDocument.of(scene);
        Map<ContentHash, byte[]> all = new LinkedHashMap<>();
        add(all, document(outline, build, document.bytes()));
        all.putAll(document.images());
        long bytes = all.values().stream().mapToLong(b -> b.length).sum();
        if (bytes > Limits.JOB || all.size() > Limits.CONTENTS) {
            throw new IllegalArgumentException("scene and textures have " + bytes + " bytes in " + all.size()
                    + " pieces; at most " + Limits.JOB + " in " + Limits.CONTENTS + " can be sent");
        }
        return new JobContent(all, document.hash(), build);
    }

    /** The job of rendering the same scene by another plan. */
    public JobContent with(RenderOutline outline) {
        Map<ContentHash, byte[]> all = new LinkedHashMap<>();
        try (DataInputStream in = new DataInputStream(new ByteArrayInputStream(contents.get(hash())))) {
            in.readUTF();
            in.readUTF();
            OutlineBytes.read(in, 1);
            OutlineBytes.readTexts(in);
            add(all, document(outline, build, in.readAllBytes()));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        hashes().stream().skip(1).forEach(image -> all.put(image, content(image)));
        return new JobContent(all, scene, build);
    }

    static ContentHash add(Map<ContentHash, byte[]> contents, byte[] content) {
        ContentHash hash = ContentHash.of(content);
        contents.put(hash, content);
        return hash;
    }

    private static Scene readScenes(DataInputStream in, SceneReader.NamedFiles files) throws IOException {
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
            instants.add(readScene(in.readNBytes(length), files));
        }
        return readScene(in.readAllBytes(), files).withInstants(instants);
    }

    private static Scene readScene(byte[] json, SceneReader.NamedFiles files) {
        return SceneReader.readNamed(new String(json, StandardCharsets.UTF_8), files, "the server's scene");
    }

    static byte[] document(RenderOutline outline, String build, byte[] scenes) {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (DataOutputStream out = new DataOutputStream(bytes)) {
            out.writeUTF(MAGIC);
            out.writeUTF(build);
            OutlineBytes.write(out, outline.settings(), outline.plan());
            OutlineBytes.write(out, outline.kinds());
            out.write(scenes);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return bytes.toByteArray();
    }

    /** The hash of the scene with its image files ({@link SceneDocument#hash}). */
    public ContentHash scene() {
        return scene;
    }

    /** The version that the job is of. */
    public String build() {
        return build;
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

    /** The parts of a job's document. */
    public record Document(Scene scene, RenderSettings settings, RenderPlan plan) {}

    /**
     * Reads a job's document.
     *
     * @param files the files that there are, by their hashes
     * @param threads the number of threads for the settings
     * @throws IOException if it is not valid; the message says why
     */
    public static Document read(byte[] document, SceneReader.NamedFiles files, String build, int threads)
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
            OutlineBytes.Decided decided = OutlineBytes.read(in, threads);
            OutlineBytes.readTexts(in);
            return new Document(readScenes(in, files), decided.settings(), decided.plan());
        } catch (EOFException | UTFDataFormatException e) {
            throw senseless(e);
        } catch (IllegalArgumentException | SceneException e) {
            throw new IOException("the job cannot be used: " + e.getMessage(), e);
        }
    }

    /** The failure for a document that ends within a value, or has no text where one is due. */
    static IOException senseless(IOException e) {
        return new IOException(
                "this is no job: " + (e instanceof EOFException ? "it ends too early" : e.getMessage()), e);
    }
}
