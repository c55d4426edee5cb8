package enlightenment.store;

import enlightenment.process.JavaProcess;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.Optional;

/** A process that writes results to a store and says, a line each, up to where they are safe; for tests that kill it. */
final class TestWriter {
    private TestWriter() {}

    /** The URL, the user, the first unit, the number after the last, and the step. */
    public static void main(String[] args) throws IOException {
        StoreLogin login = args[1].isEmpty()
                ? StoreLogin.NONE
                : new StoreLogin(Optional.of(args[1]), Optional.ofNullable(System.getenv("TEST_PASSWORD")));
        int step = Integer.parseInt(args[4]);
        try (StoreArchive archive =
                TestStores.open(StoreAddress.of(args[0]), login, TestStores.ID, StoredSamples.PIXELS)) {
            int plan = archive.keep(TestStores.PLAN);
            for (int unit = Integer.parseInt(args[2]); unit != Integer.parseInt(args[3]); unit += step) {
                archive.keepSamples(plan, unit, 0, unit % 50, TestStores.samples(unit));
                archive.keep(plan, unit, "writer " + args[2], TestStores.result(unit));
                if (unit % 8 == 0) {
                    archive.write();
                    System.out.println(unit);
                }
            }
        }
        System.out.println("done");
    }

    /** The process. */
    static Process start(StoreAddress address, String user, int first, int end, int step) throws IOException {
        return start(address, user, first, end, step, "");
    }

    /** The same with a password. */
    static Process start(StoreAddress address, String user, int first, int end, int step, String password)
            throws IOException {
        ProcessBuilder builder = JavaProcess.of(TestWriter.class, address.url(), user, first, end, step)
                .redirectError(ProcessBuilder.Redirect.INHERIT);
        builder.environment().put("TEST_PASSWORD", password);
        return builder.start();
    }

    /**
     * Reads what a writer says, up to the end or until it has said so many lines, when it is killed; returns the last unit that is safe.
     */
    static int lastSafe(Process writer, int lines) {
        int last = -1;
        try (BufferedReader in =
                new BufferedReader(new InputStreamReader(writer.getInputStream(), StandardCharsets.UTF_8))) {
            int read = 0;
            for (String line = in.readLine(); line != null; line = in.readLine()) {
                if (++read == lines) {
                    // The handle leaves the stream open, with what the writer has said.
                    writer.toHandle().destroyForcibly();
                }
                if (line.matches("\\d+")) {
                    last = Integer.parseInt(line);
                }
            }
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return last;
    }
}
