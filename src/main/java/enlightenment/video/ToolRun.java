package enlightenment.video;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;

/** Another program while it runs for us. What it says is kept up to a limit; it is killed as soon as we are to stop. */
final class ToolRun {
    private static final int MOST_SAID = 1 << 18;
    private static final int PERIOD_MILLIS = 100;
    private static final int LAST_WORDS_MILLIS = 2000;

    private final Process process;
    private final BooleanSupplier cancelled;
    private final Said output;
    private final Said errors;
    private final Thread watch;

    private ToolRun(Process process, BooleanSupplier cancelled) {
        this.process = process;
        this.cancelled = cancelled;
        output = new Said(process.getInputStream());
        errors = new Said(process.getErrorStream());
        watch = new Thread(this::watch, "watch");
        watch.setDaemon(true);
        watch.start();
    }

    /**
     * Starts a program.
     *
     * @param command the program's file and its arguments, each as it is
     * @param cancelled once true, the program is killed
     * @throws IOException with a message, if it cannot be started
     */
    static ToolRun start(List<String> command, BooleanSupplier cancelled) throws IOException {
        try {
            return new ToolRun(new ProcessBuilder(command).start(), cancelled);
        } catch (IOException e) {
            throw new IOException(command.get(0) + " cannot be started: " + e.getMessage(), e);
        }
    }

    /** Where the program reads from. */
    OutputStream input() {
        return process.getOutputStream();
    }

    private void watch() {
        try {
            while (!process.waitFor(PERIOD_MILLIS, TimeUnit.MILLISECONDS)) {
                if (cancelled.getAsBoolean()) {
                    kill();
                }
            }
        } catch (InterruptedException e) {
            kill();
        }
    }

    private void kill() {
        process.destroyForcibly();
    }

    /** Kills the program and waits until it is gone. */
    void end() {
        kill();
        try {
            process.waitFor();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    /**
     * Waits for the end.
     *
     * @return the exit code
     * @throws CancellationException if we were to stop meanwhile
     */
    int await() throws IOException {
        try {
            int code = process.waitFor();
            watch.join();
            // A program that it started may still hold them.
            output.thread.join(LAST_WORDS_MILLIS);
            errors.thread.join(LAST_WORDS_MILLIS);
            if (cancelled.getAsBoolean()) {
                throw new CancellationException("the film was not finished");
            }
            return code;
        } catch (InterruptedException e) {
            kill();
            Thread.currentThread().interrupt();
            throw new CancellationException("the film was not finished");
        }
    }

    String output() {
        return output.text();
    }

    String errors() {
        return errors.text();
    }

    /** Reads one of the program's streams to its end, so that the program never waits for us; keeps the beginning. */
    private static final class Said {
        private final ByteArrayOutputStream kept = new ByteArrayOutputStream();
        private final Thread thread;

        Said(InputStream stream) {
            thread = new Thread(() -> read(stream), "listen");
            thread.setDaemon(true);
            thread.start();
        }

        private void read(InputStream stream) {
            byte[] buffer = new byte[8192];
            try (stream) {
                for (int n = stream.read(buffer); n >= 0; n = stream.read(buffer)) {
                    synchronized (kept) {
                        kept.write(buffer, 0, Math.min(n, MOST_SAID - kept.size()));
                    }
                }
            } catch (IOException e) {
                // The program was killed: its output is not needed.
                return;
            }
        }

        String text() {
            synchronized (kept) {
                return kept.toString(StandardCharsets.UTF_8);
            }
        }
    }
}
