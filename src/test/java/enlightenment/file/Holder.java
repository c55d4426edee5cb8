package enlightenment.file;

import enlightenment.process.JavaProcess;
import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;

/** A process that is in the middle of writing a file until it is killed. */
final class Holder {
    private Holder() {}

    /** {@code write FILE}: writes half of a file; {@code lock FILE}: locks a file that is there. */
    public static void main(String[] args) throws IOException, InterruptedException {
        Path file = Path.of(args[1]);
        if (args[0].equals("lock")) {
            try (FileChannel channel = FileChannel.open(file, StandardOpenOption.WRITE)) {
                channel.lock();
                waitToBeKilled();
            }
        }
        WholeFile.write(file, out -> {
            out.write("half of it".getBytes());
            out.flush();
            try {
                waitToBeKilled();
            } catch (InterruptedException e) {
                throw new IOException(e);
            }
        });
    }

    private static void waitToBeKilled() throws InterruptedException {
        System.out.println("ready");
        Thread.sleep(Long.MAX_VALUE);
    }

    /** Starts one and returns when it is in the middle. */
    static Process start(String what, Path file) throws IOException {
        Process process = JavaProcess.of(Holder.class, what, file)
                .redirectError(ProcessBuilder.Redirect.INHERIT)
                .start();
        byte[] word = process.getInputStream().readNBytes("ready".length());
        if (!new String(word).equals("ready")) {
            process.destroyForcibly();
            throw new IOException("the other process did not start: " + new String(word));
        }
        return process;
    }
}
