package enlightenment.net.secure;

import enlightenment.file.TemporaryFile;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileAttribute;
import java.nio.file.attribute.PosixFilePermission;
import java.nio.file.attribute.PosixFilePermissions;
import java.security.SecureRandom;
import java.util.EnumSet;
import java.util.HexFormat;
import java.util.Set;
import java.util.function.Consumer;

/** Files with a secret: only their owner may read them, as far as the file system knows POSIX permissions. */
public final class SecretFile {
    private static final Set<PosixFilePermission> OWNER = EnumSet.of(
            PosixFilePermission.OWNER_READ, PosixFilePermission.OWNER_WRITE, PosixFilePermission.OWNER_EXECUTE);

    private static final Set<PosixFilePermission> READ_AND_WRITE =
            EnumSet.of(PosixFilePermission.OWNER_READ, PosixFilePermission.OWNER_WRITE);

    private static final int RANDOM_BYTES = 16;

    private SecretFile() {}

    /** An unguessable secret: 128 random bits in hexadecimal. */
    static String random() {
        byte[] bits = new byte[RANDOM_BYTES];
        new SecureRandom().nextBytes(bits);
        return HexFormat.of().formatHex(bits);
    }

    /** Writes a file that must not exist, whole or not at all. */
    static void create(Path file, String text) throws IOException {
        Path folder = file.toAbsolutePath().getParent();
        if (folder == null || !Files.isDirectory(folder)) {
            throw new IOException(file + ": cannot be made: there is no folder " + folder);
        }
        if (!Files.isWritable(folder)) {
            throw new IOException(file + ": cannot be made: no permission to write to the folder " + folder);
        }
        TemporaryFile.clean(folder);
        // Born with the owner's permissions only, so that there is no moment at which others can read it.
        try (TemporaryFile part = TemporaryFile.in(folder, ownersOnly(folder))) {
            part.stream().write(text.getBytes(StandardCharsets.US_ASCII));
            part.force();
            part.become(file);
        } catch (FileAlreadyExistsException e) {
            throw new IOException(file + ": was made by somebody else just now; start again", e);
        } catch (IOException e) {
            throw new IOException(file + ": cannot be made: " + e.getMessage(), e);
        }
    }

    /** As far as the file system knows permissions. */
    static FileAttribute<?>[] ownersOnly(Path folder) throws IOException {
        boolean posix = Files.getFileStore(folder).supportsFileAttributeView("posix");
        return posix
                ? new FileAttribute<?>[] {PosixFilePermissions.asFileAttribute(READ_AND_WRITE)}
                : new FileAttribute<?>[0];
    }

    /** Logs a warning if others than the owner may read or change the file. Needs a file system with POSIX permissions. */
    public static void warnIfOpen(Path file, Consumer<String> log) throws IOException {
        if (!file.getFileSystem().supportedFileAttributeViews().contains("posix") || !Files.isRegularFile(file)) {
            return;
        }
        Set<PosixFilePermission> others = Files.getPosixFilePermissions(file);
        others.removeAll(OWNER);
        if (!others.isEmpty()) {
            log.accept(file + ": others on this machine may read or change this secret (chmod 600 " + file + ")");
        }
    }
}
