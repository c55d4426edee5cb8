package enlightenment.file;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/** A short mark of this machine in the names of its temporary files: tells it from others that share its folders. */
final class HostTag {
    /** Up to eight hexadecimal digits made of the machine's name. */
    static final String HASH = Integer.toHexString(name().hashCode());

    private HostTag() {}

    /** Asks no network. */
    private static String name() {
        try {
            return Files.readString(Path.of("/etc/hostname")).strip();
        } catch (IOException | RuntimeException e) {
            String name = System.getenv("COMPUTERNAME");
            return name == null ? String.valueOf(System.getenv("HOSTNAME")) : name;
        }
    }
}
