package enlightenment.net.job;

import enlightenment.engine.RenderOutline;
import enlightenment.engine.UnitGroups;
import enlightenment.file.ContentHash;
import enlightenment.job.SceneDocument;
import enlightenment.net.protocol.Limits;
import enlightenment.scene.Scene;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.UTFDataFormatException;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * A job of many pictures. Its document has the build, the number of pictures and, for each, how many of its tiles are one tile of the
 * job, how many of those it has, and its document as {@link JobContent} makes it, with its length before it. Image files that several of
 * them need are one content. The tiles of the first picture come first, then those of the second, and so on.
 */
public final class FilmContent {
    private static final String MAGIC = "enlightenment film 1";

    private final String build;
    private final List<Frame> frames = new ArrayList<>();
    private final SceneDocument.Images images = new SceneDocument.Images();
    private long bytes;

    /** A film without pictures. */
    public FilmContent(String build) {
        this.build = build;
    }

    /**
     * A picture.
     *
     * @param group how many consecutive tiles of the picture are one of the job ({@link UnitGroups})
     * @param tiles number of its tiles in the job
     * @param document the picture's own
     */
    public record Frame(int group, int tiles, byte[] document) {}

    /**
     * Adds the next picture.
     *
     * @param group how many of its tiles are one of the job, at least 1
     * @throws enlightenment.scene.SceneException if an image file cannot be read or the scene cannot be written down
     * @throws IllegalArgumentException if the job is larger than {@link Limits#JOB}
     */
    public void add(Scene scene, RenderOutline outline, int group) {
        byte[] document = JobContent.document(
                outline, build, SceneDocument.of(scene, images).bytes());
        frames.add(new Frame(group, UnitGroups.of(outline, group).count(), document));
        bytes += document.length + 3L * Integer.BYTES;
        Map<ContentHash, byte[]> files = images.contents();
        long all = bytes + files.values().stream().mapToLong(b -> b.length).sum();
        if (all > Limits.JOB || files.size() >= Limits.CONTENTS) {
            throw new IllegalArgumentException(
                    "the scenes of " + frames.size() + " frames with their textures have " + all + " bytes in "
                            + (files.size() + 1) + " pieces; at most " + Limits.JOB + " in " + Limits.CONTENTS
                            + " can be sent: fewer frames at once are smaller");
        }
    }

    /** The pictures, in their order. */
    public List<Frame> frames() {
        return List.copyOf(frames);
    }

    /** The image files. */
    public Map<ContentHash, byte[]> images() {
        return images.contents();
    }

    /** The job. */
    public JobContent content() {
        ByteArrayOutputStream document = new ByteArrayOutputStream();
        try (DataOutputStream out = new DataOutputStream(document)) {
            out.writeUTF(MAGIC);
            out.writeUTF(build);
            out.writeInt(frames.size());
            for (Frame frame : frames) {
                out.writeInt(frame.group);
                out.writeInt(frame.tiles);
                out.writeInt(frame.document.length);
                out.write(frame.document);
            }
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        byte[] whole = document.toByteArray();
        ContentHash hash = ContentHash.of(whole);
        Map<ContentHash, byte[]> all = new LinkedHashMap<>();
        all.put(hash, whole);
        all.putAll(images.contents());
        return new JobContent(all, hash, build);
    }

    /**
     * The pictures that a job renders.
     *
     * @param frames its pictures, at least one
     * @param isFilm whether the job is a film, if only of one picture: its units are not those of that picture
     */
    public record Pictures(List<Frame> frames, boolean isFilm) {}

    /**
     * The pictures of a job's document: what was added, or the document itself where it is one picture's.
     *
     * @param tiles number of tiles of the whole job
     * @throws IOException if it makes no sense; the message says why
     */
    public static Pictures read(byte[] document, int tiles, String build) throws IOException {
        try (DataInputStream in = new DataInputStream(new ByteArrayInputStream(document))) {
            if (!in.readUTF().equals(MAGIC)) {
                return new Pictures(List.of(new Frame(1, tiles, document)), false);
            }
            String theirs = in.readUTF();
            if (!theirs.equals(build)) {
                throw new IOException("the job is of version " + theirs + ", this is " + build);
            }
            List<Frame> frames = new ArrayList<>();
            long sum = 0;
            for (int left = in.readInt(); left > 0; left--) {
                int group = in.readInt();
                int mine = in.readInt();
                int length = in.readInt();
                sum += mine;
                if (group < 1 || mine < 1 || sum > tiles || length < 0 || length > in.available()) {
                    throw new IOException("frame " + frames.size() + " of the job has " + mine + " tiles in groups of "
                            + group + ", and " + length + " bytes");
                }
                frames.add(new Frame(group, mine, in.readNBytes(length)));
            }
            if (frames.isEmpty() || sum != tiles) {
                throw new IOException("the job has " + tiles + " tiles at the server, " + sum + " here");
            }
            return new Pictures(frames, true);
        } catch (EOFException | UTFDataFormatException e) {
            throw JobContent.senseless(e);
        }
    }
}
