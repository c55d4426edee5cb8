package enlightenment.file;

import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;

/** Pipes with a name, for tests, which are left out where there is no {@code mkfifo}. */
public final class NamedPipe {
    private NamedPipe() {}

    /** Makes a pipe, to which somebody writes this as soon as it is read. */
    public static void writing(Path pipe, byte[] content) throws InterruptedException {
        assumeTrue(isMade(pipe), "no pipe can be made here");
        Thread writer = new Thread(() -> {
            try {
                Files.write(pipe, content);
            } catch (IOException e) {
                throw new UncheckedIOException(e);
            }
        });
        writer.setDaemon(true);
        writer.start();
    }

    private static boolean isMade(Path pipe) throws InterruptedException {
        try {
            return new ProcessBuilder("mkfifo", pipe.toString()).start().waitFor() == 0;
        } catch (IOException e) {
            return false;
        }
    }
}
