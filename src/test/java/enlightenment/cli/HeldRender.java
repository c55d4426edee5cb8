package enlightenment.cli;

import enlightenment.file.WholeFile;
import java.io.IOException;
import java.nio.file.Path;

/** A process in the middle of writing a picture, until it is killed. */
final class HeldRender {
    private HeldRender() {}

    public static void main(String[] args) throws IOException {
        WholeFile.write(Path.of(args[0]), out -> {
            out.write(new byte[1 << 17]);
            System.out.print("r");
            System.out.flush();
            try {
                Thread.sleep(Long.MAX_VALUE);
            } catch (InterruptedException e) {
                throw new IOException(e);
            }
        });
    }
}
