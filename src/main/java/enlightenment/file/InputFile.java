package enlightenment.file;

import java.io.FilterInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;

/** Reads files so that every failure, also in the middle, names the file ({@link FileFailure}). */
public final class InputFile {
    /** What kind of thing a file is, in the mode that POSIX gives it: devices of characters and of blocks. */
    private static final int KIND = 0170000;

    private static final int CHARACTERS = 0020000;
    private static final int BLOCKS = 0060000;

    /** Somewhat below the longest array that there can be. */
    private static final int LONGEST = Integer.MAX_VALUE - 64;

    private InputFile() {}

    /**
     * Opens a file.
     *
     * @throws IOException if that fails or it is a folder, which Linux opens as well; it names the file, and so do those of the stream
     */
    public static InputStream open(Path file) throws IOException {
        if (Files.isDirectory(file)) {
            throw FileFailure.because(file, "it is a folder");
        }
        return new Naming(file, Files.newInputStream(file));
    }

    /**
     * The first bytes, or all if there are no more: for files that are short, whatever is named in their place.
     *
     * @param most how many at most
     */
    public static byte[] start(Path file, int most) throws IOException {
        try (InputStream in = open(file)) {
            return in.readNBytes(most);
        }
    }

    /**
     * All bytes of a file or a pipe.
     *
     * @throws IOException naming the file; also for devices, some of which have no end, and for more than 2 GiB
     */
    public static byte[] bytes(Path file) throws IOException {
        requireEnd(file);
        if (Files.isRegularFile(file)) {
            return bytesOfRegular(file);
        }
        try (InputStream in = open(file)) {
            byte[] all = in.readNBytes(LONGEST);
            if (in.read() >= 0) {
                throw tooLong(file);
            }
            return all;
        }
    }

    /**
     * Refuses devices, some of which have no end.
     *
     * @throws IOException naming the file
     */
    public static void requireEnd(Path file) throws IOException {
        if (isDevice(file)) {
            throw FileFailure.because(file, "it is a device, and what it gives may have no end");
        }
    }

    /** All at once, as the length is known: large pictures would take twice the memory. */
    private static byte[] bytesOfRegular(Path file) throws IOException {
        try {
            if (Files.size(file) > LONGEST) {
                throw tooLong(file);
            }
            return Files.readAllBytes(file);
        } catch (IOException e) {
            throw FileFailure.named(file, e);
        }
    }

    private static IOException tooLong(Path file) {
        return FileFailure.because(file, "it has more than 2 GiB");
    }

    private static boolean isDevice(Path file) throws IOException {
        if (Files.isRegularFile(file) || !Files.exists(file)) {
            return false;
        }
        try {
            int kind = (Integer) Files.getAttribute(file, "unix:mode") & KIND;
            return kind == CHARACTERS || kind == BLOCKS;
        } catch (UnsupportedOperationException | IllegalArgumentException e) {
            // There are no such modes here, nor such devices.
            return false;
        }
    }

    /** Its failures name the file. */
    private static final class Naming extends FilterInputStream {
        private final Path file;

        Naming(Path file, InputStream in) {
            super(in);
            this.file = file;
        }

        @Override
        public int read() throws IOException {
            try {
                return in.read();
            } catch (IOException e) {
                throw FileFailure.named(file, e);
            }
        }

        @Override
        public int read(byte[] to, int from, int length) throws IOException {
            try {
                return in.read(to, from, length);
            } catch (IOException e) {
                throw FileFailure.named(file, e);
            }
        }
    }
}
