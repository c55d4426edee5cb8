package enlightenment.mesh.input;

import enlightenment.file.InputFile;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;

/** The bytes of a mesh file, on disk or in memory, with their number and the name that messages give them. */
public final class MeshSource {
    public final String name;
    public final long size;
    private final Path file;

    /** The content; null if it is read from the file. */
    private final byte[] content;

    private MeshSource(String name, long size, Path file, byte[] content) {
        this.name = name;
        this.size = size;
        this.file = file;
        this.content = content;
    }

    /** A file. Pipes are read at once, as their length is not known; devices are refused. */
    public static MeshSource of(Path file) throws IOException {
        if (Files.isRegularFile(file)) {
            return new MeshSource(file.toString(), Files.size(file), file, null);
        }
        return of(InputFile.bytes(file), file.toString());
    }

    public static MeshSource of(byte[] content, String name) {
        return new MeshSource(name, content.length, null, content);
    }

    /** A stream of the bytes from an offset on, which is at most the size. */
    public InputStream open(long offset) throws IOException {
        if (content != null) {
            return new ByteArrayInputStream(content, (int) offset, content.length - (int) offset);
        }
        InputStream in = InputFile.open(file);
        try {
            in.skipNBytes(offset);
            return in;
        } catch (IOException e) {
            in.close();
            throw e;
        }
    }

    /** The first bytes, or all if there are fewer. */
    public byte[] start(int most) throws IOException {
        try (InputStream in = open(0)) {
            return in.readNBytes(most);
        }
    }

    /** A failure whose message is {@code NAME: REASON}. */
    public FileSystemException failure(String reason) {
        return new FileSystemException(name, null, reason);
    }
}
