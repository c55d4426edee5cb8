package enlightenment.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.process.JavaProcess;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.extension.AfterEachCallback;
import org.junit.jupiter.api.extension.ExtensionContext;

/** Starts the command line as processes of their own, and kills what is left of them after each test. */
public final class Processes implements AfterEachCallback {
    /** As long as anything may take. */
    private static final long PATIENCE_SECONDS = 300;

    private static final int PAUSE_MILLIS = 3;

    private final List<Running> started = new ArrayList<>();

    /** One that runs, or has run. What it says, to whichever of its outputs, is kept in a file. */
    public record Running(Process process, Path log) {
        /** What it has said so far. */
        public String said() throws IOException {
            return Files.readString(log);
        }

        /** Waits until it has come so far; fails if it ends before, or does not come so far. */
        public void until(String what, Callable<Boolean> isSo) throws Exception {
            long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(PATIENCE_SECONDS);
            boolean continues = true;
            while (!isSo.call()) {
                assertTrue(continues, "waited in vain until " + what + ": " + said());
                continues = process.isAlive() && System.nanoTime() - end < 0;
                process.waitFor(PAUSE_MILLIS, TimeUnit.MILLISECONDS);
            }
        }

        public void untilSaid(String words) throws Exception {
            until("it says " + words, () -> said().contains(words));
        }

        /** Kills it as {@code kill -9} does; whether there was somebody to kill. */
        public boolean kill() throws InterruptedException {
            boolean isAlive = process.isAlive();
            process.destroyForcibly().waitFor();
            return isAlive;
        }

        /** Kills it once that is so, and a moment more has passed; whether there was somebody to kill. */
        public boolean killOnce(Callable<Boolean> isSo, long nanosMore) throws Exception {
            while (process.isAlive() && !isSo.call()) {
                process.waitFor(PAUSE_MILLIS, TimeUnit.MILLISECONDS);
            }
            process.waitFor(nanosMore, TimeUnit.NANOSECONDS);
            return kill();
        }

        /** Waits until it ends by itself; what it has said. */
        public String ended(int code) throws IOException, InterruptedException {
            assertTrue(process.waitFor(PATIENCE_SECONDS, TimeUnit.SECONDS), () -> log + " does not end");
            assertEquals(code, process.exitValue(), said());
            return said();
        }
    }

    /** Starts a command, which tells of its progress only where it is told to, and whose words are kept in the folder. */
    public Running start(Path folder, Object... args) throws IOException {
        Path log = folder.resolve("log-" + started.size());
        Process process = JavaProcess.of(Main.class, (Object[]) CliRun.quiet(CliRun.texts(args)))
                .redirectErrorStream(true)
                .redirectOutput(log.toFile())
                .start();
        Running running = new Running(process, log);
        started.add(running);
        return running;
    }

    @Override
    public void afterEach(ExtensionContext context) throws InterruptedException {
        for (Running running : started) {
            running.kill();
        }
    }
}
