package enlightenment.net.job;

import enlightenment.engine.FilmAssembly;
import enlightenment.engine.FilmRoom;
import enlightenment.engine.OutlineBytes;
import enlightenment.engine.RenderOutline;
import enlightenment.file.ContentHash;
import enlightenment.file.InputFile;
import enlightenment.file.WholeFile;
import enlightenment.job.Build;
import enlightenment.math.InvalidValueException;
import java.io.BufferedInputStream;
import java.io.Closeable;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.io.UTFDataFormatException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.DigestOutputStream;
import java.security.MessageDigest;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.IntFunction;

/**
 * The tiles of a part of a render in a file: magic, head, number of tiles, tiles (number, length, bytes), and the SHA-256 of
 * all that. Numbers with their most significant byte first.
 */
public final class PartFile implements Closeable {
    private static final byte[] MAGIC = "ENLPART4".getBytes(StandardCharsets.US_ASCII);
    private static final int BUFFER = 1 << 16;

    private final Path file;
    private final DataInputStream in;
    private final Head head;
    private int left;

    private PartFile(Path file, DataInputStream in, Head head, int tiles) {
        this.file = file;
        this.in = in;
        this.head = head;
        left = tiles;
    }

    /** The header of a part: part {@code part} of {@code parts}, with the texts for the picture's file. */
    public record Head(ContentHash job, RenderOutline outline, Map<String, String> text, int part, int parts) {}

    /** A tile. */
    public record Tile(int tile, byte[] bytes) {}

    /**
     * Writes a part, whole or not at all.
     *
     * @param tiles their numbers, ascending
     * @param results gives the bytes of a tile, one after the other
     */
    public static void write(Path file, Head head, int[] tiles, IntFunction<byte[]> results) throws IOException {
        WholeFile.write(file, plain -> {
            MessageDigest digest = ContentHash.sha256();
            DataOutputStream out = new DataOutputStream(new DigestOutputStream(plain, digest));
            out.write(MAGIC);
            writeHead(out, head);
            out.writeInt(tiles.length);
            for (int tile : tiles) {
                byte[] bytes = results.apply(tile);
                out.writeInt(tile);
                out.writeInt(bytes.length);
                out.write(bytes);
            }
            out.flush();
            plain.write(digest.digest());
        });
    }

    private static void writeHead(DataOutputStream out, Head head) throws IOException {
        out.writeUTF(Build.number());
        out.write(head.job().toBytes());
        OutlineBytes.write(out, head.outline());
        List<String> text = new ArrayList<>();
        head.text().forEach((key, value) -> text.addAll(List.of(key, value)));
        OutlineBytes.write(out, text);
        out.writeInt(head.part());
        out.writeInt(head.parts());
    }

    /** Opens a part that was written; fails if it is none, damaged, or of another version. */
    public static PartFile open(Path file) throws IOException {
        checkWhole(file);
        DataInputStream in = new DataInputStream(new BufferedInputStream(InputFile.open(file), BUFFER));
        try {
            in.skipNBytes(MAGIC.length);
            String build = in.readUTF();
            if (!build.equals(Build.number())) {
                throw new IOException(file + ": was made by version " + build + ", this is " + Build.number());
            }
            ContentHash job = ContentHash.fromBytes(in.readNBytes(ContentHash.BYTES));
            RenderOutline outline = OutlineBytes.readOutline(in, 1);
            List<String> list = OutlineBytes.readTexts(in);
            Map<String, String> text = new LinkedHashMap<>();
            for (int i = 0; i + 1 < list.size(); i += 2) {
                text.put(list.get(i), list.get(i + 1));
            }
            Head head = new Head(job, outline, text, in.readInt(), in.readInt());
            int tiles = in.readInt();
            if (head.part() < 1 || head.part() > head.parts() || tiles < 0) {
                throw new IllegalArgumentException(
                        tiles + " tiles of part " + head.part() + " of " + head.parts() + " parts");
            }
            return new PartFile(file, in, head, tiles);
        } catch (IllegalArgumentException | UTFDataFormatException e) {
            in.close();
            throw senseless(file, e);
        } catch (EOFException e) {
            in.close();
            throw endsTooEarly(file);
        } catch (IOException e) {
            in.close();
            throw e;
        }
    }

    /** The failure for a file with numbers that cannot be right, although none is missing. */
    private static IOException senseless(Path file, Exception e) {
        return new IOException(file + ": makes no sense: " + e.getMessage(), e);
    }

    private static IOException endsTooEarly(Path file) {
        return new IOException(file + ": ends too early");
    }

    /**
     * A picture to put the tiles into.
     *
     * @param room where its pixels may be
     * @throws IOException if there can be no picture of the kind that the head tells of
     */
    public FilmAssembly assembly(FilmRoom room) throws IOException {
        try {
            return new FilmAssembly(head.outline(), room);
        } catch (InvalidValueException e) {
            if (e.key().equals("size")) {
                // The file makes sense; there is too little room here.
                throw new IOException(file + ": " + e.problem(), e);
            }
            throw senseless(file, e);
        } catch (IllegalArgumentException | ArithmeticException e) {
            throw senseless(file, e);
        }
    }

    private static void checkWhole(Path file) throws IOException {
        MessageDigest digest = ContentHash.sha256();
        byte[] buffer = new byte[BUFFER];
        try (InputStream in = InputFile.open(file)) {
            long content = Files.size(file) - ContentHash.BYTES;
            byte[] magic = in.readNBytes(MAGIC.length);
            if (!Arrays.equals(magic, MAGIC)) {
                throw new IOException(file + ": is not a part of a render");
            }
            digest.update(magic);
            for (long left = content - magic.length; left > 0; ) {
                int n = in.read(buffer, 0, (int) Math.min(buffer.length, left));
                if (n < 0) {
                    break;
                }
                digest.update(buffer, 0, n);
                left -= n;
            }
            if (!Arrays.equals(digest.digest(), in.readNBytes(ContentHash.BYTES))) {
                throw new IOException(file + ": is damaged or cut short; render this part again");
            }
        }
    }

    public Head head() {
        return head;
    }

    public Path file() {
        return file;
    }

    /** The next tile, checked; null after the last. */
    public Tile next(FilmAssembly film) throws IOException {
        try {
            return read(film);
        } catch (EOFException e) {
            throw endsTooEarly(file);
        }
    }

    private Tile read(FilmAssembly film) throws IOException {
        if (left == 0) {
            if (in.readNBytes(ContentHash.BYTES + 1).length != ContentHash.BYTES) {
                throw new IOException(file + ": its tiles are not as long as they say");
            }
            return null;
        }
        left--;
        int tile = in.readInt();
        int length = in.readInt();
        if (tile < 0 || tile >= film.units() || length < 0 || length > film.longest(tile)) {
            throw new IOException(file + ": tile " + tile + " with " + length + " bytes makes no sense");
        }
        byte[] bytes = in.readNBytes(length);
        String problem = film.problem(tile, bytes).orElse(null);
        if (problem != null) {
            throw new IOException(file + ": tile " + tile + ": " + problem);
        }
        return new Tile(tile, bytes);
    }

    @Override
    public void close() throws IOException {
        in.close();
    }
}
