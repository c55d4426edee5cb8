package enlightenment.net.job;

import enlightenment.engine.RenderOutline;
import enlightenment.file.ContentHash;
import enlightenment.net.protocol.Limits;
import enlightenment.scene.Scene;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * A job of many pictures. Its document has the build, the number of pictures and, for each, the number of its tiles and its document as
 * {@link JobContent} makes it, with its length before it. Image files that several of them need are one content. The tiles of the first
 * picture come first, then those of the second, and so on.
 */
public final class FilmContent {
    private static final String MAGIC = "enlightenment film 1";

    private final String build;
    private final List<Frame> frames = new ArrayList<>();
    private final Map<Path, ContentHash> byPath = new LinkedHashMap<>();
    private final Map<ContentHash, byte[]> images = new LinkedHashMap<>();
    private long bytes;

    /** A film without pictures. */
    public FilmContent(String build) {
        this.build = build;
    }

    /** A picture: the number of its tiles, and its document. */
    public record Frame(int tiles, byte[] document) {}

    /**
     * Adds the next picture.
     *
     * @throws enlightenment.scene.SceneException if an image file cannot be read or the scene cannot be written down
     * @throws IllegalArgumentException if the job is larger than {@link Limits#JOB}
     */
    public void add(Scene scene, RenderOutline outline) {
        byte[] document = JobContent.document(outline, build, JobContent.scenes(scene, this::name));
        frames.add(new Frame(outline.units(), document));
        bytes += document.length + 2L * Integer.BYTES;
        long all = bytes + images.values().stream().mapToLong(b -> b.length).sum();
        if (all > Limits.JOB || images.size() >= Limits.CONTENTS) {
            throw new IllegalArgumentException("the scenes of " + frames.size() + " frames with their textures have "
                    + all
                    + " bytes in " + (images.size() + 1) + " pieces; at most " + Limits.JOB + " in " + Limits.CONTENTS
                    + " can be sent: fewer frames at once are smaller");
        }
    }

    private String name(Path file) {
        return byPath.computeIfAbsent(file, f -> JobContent.add(images, JobContent.read(f)))
                .toString();
    }

    /** The documents of the pictures, in their order. */
    public List<Frame> frames() {
        return List.copyOf(frames);
    }

    /** The image files. */
    public Map<ContentHash, byte[]> images() {
        return Map.copyOf(images);
    }

    /** The job. */
    public JobContent content() {
        ByteArrayOutputStream document = new ByteArrayOutputStream();
        try (DataOutputStream out = new DataOutputStream(document)) {
            out.writeUTF(MAGIC);
            out.writeUTF(build);
            out.writeInt(frames.size());
            for (Frame frame : frames) {
                out.writeInt(frame.tiles);
                out.writeInt(frame.document.length);
                out.write(frame.document);
            }
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        Map<ContentHash, byte[]> all = new LinkedHashMap<>();
        JobContent.add(all, document.toByteArray());
        all.putAll(images);
        return new JobContent(all);
    }

    /**
     * The pictures of a job's document: what was added, or the document itself where it is one picture's, of which the number of tiles
     * is not known then.
     *
     * @param tiles number of tiles of the whole job
     * @throws IOException if it makes no sense; the message says why
     */
    public static List<Frame> read(byte[] document, int tiles, String build) throws IOException {
        try (DataInputStream in = new DataInputStream(new ByteArrayInputStream(document))) {
            if (!in.readUTF().equals(MAGIC)) {
                return List.of(new Frame(tiles, document));
            }
            String theirs = in.readUTF();
            if (!theirs.equals(build)) {
                throw new IOException("the job is of version " + theirs + ", this is " + build);
            }
            List<Frame> frames = new ArrayList<>();
            long sum = 0;
            for (int left = in.readInt(); left > 0; left--) {
                int mine = in.readInt();
                int length = in.readInt();
                sum += mine;
                if (mine < 1 || sum > tiles || length < 0 || length > in.available()) {
                    throw new IOException(
                            "frame " + frames.size() + " of the job has " + mine + " tiles and " + length + " bytes");
                }
                frames.add(new Frame(mine, in.readNBytes(length)));
            }
            if (sum != tiles) {
                throw new IOException("the job has " + tiles + " tiles at the server, " + sum + " here");
            }
            return frames;
        }
    }
}
