package enlightenment.file;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/** Tells this machine from others that share its folders. */
final class Machine {
    /** Up to eight hexadecimal digits made of the machine's name. */
    static final String HASH = Integer.toHexString(name().hashCode());

    private Machine() {}

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
