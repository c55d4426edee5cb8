package enlightenment.file;

import java.io.BufferedInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;

/**
 * Files {@code PREFIX-1.EXT}, {@code PREFIX-2.EXT} and so on of a folder. None is replaced: one that is there and has the bytes that are to be written
 * is taken as it is, and the number of any other is skipped. So who writes the same files again gets the same names.
 */
public final class NumberedFiles {
    private final Path folder;
    private final String prefix;
    private int last;

    /**
     * No file yet.
     *
     * @param folder where they go; must be there when the first one is written
     * @param prefix of their names
     */
    public NumberedFiles(Path folder, String prefix) {
        this.folder = folder;
        this.prefix = prefix;
    }

    /**
     * Writes the next file, or finds it.
     *
     * @param extension of its name, without the dot
     * @param content its bytes, which must be the same each time
     * @return the file, whose number is higher than those before
     * @throws IOException with a message that names the file and the reason
     */
    public Path write(String extension, WholeFile.Content content) throws IOException {
        while (true) {
            last++;
            Path file = folder.resolve(prefix + "-" + last + "." + extension);
            if (!Files.exists(file, LinkOption.NOFOLLOW_LINKS)) {
                WholeFile.write(file, content);
                return file;
            }
            if (holds(file, content)) {
                return file;
            }
        }
    }

    private static boolean holds(Path file, WholeFile.Content content) throws IOException {
        if (!Files.isRegularFile(file) || !Files.isReadable(file)) {
            return false;
        }
        try (InputStream in = new BufferedInputStream(Files.newInputStream(file))) {
            Comparison comparison = new Comparison(in);
            content.writeTo(comparison);
            return comparison.isSame && in.read() < 0;
        }
    }

    /** Compares what is written with a stream. */
    private static final class Comparison extends OutputStream {
        private final InputStream expected;
        private boolean isSame = true;

        Comparison(InputStream expected) {
            this.expected = expected;
        }

        @Override
        public void write(int b) throws IOException {
            isSame = isSame && expected.read() == (b & 0xff);
        }

        @Override
        public void write(byte[] bytes, int from, int length) throws IOException {
            for (int i = from; i < from + length && isSame; i++) {
                write(bytes[i]);
            }
        }
    }
}
