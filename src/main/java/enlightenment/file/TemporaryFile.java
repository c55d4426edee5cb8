package enlightenment.file;

import java.io.Closeable;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.channels.Channels;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.channels.OverlappingFileLockException;
import java.nio.file.AtomicMoveNotSupportedException;
import java.nio.file.DirectoryIteratorException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.FileAttribute;
import java.nio.file.attribute.PosixFilePermission;
import java.nio.file.attribute.PosixFilePermissions;
import java.nio.file.attribute.UserPrincipal;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ThreadLocalRandom;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * A file that becomes another one, or goes. It is called {@code .enlightenment-MACHINE-PROCESS-RANDOM.tmp} and locked as long as it is in
 * use, so that files that a killed process left behind can be distinguished from those in use, and the next process that writes to the
 * folder can remove them ({@link #clean}).
 *
 * <p>A file is removed only if no process holds its lock and, beyond that, its process is not alive as far as that can be found out: on
 * this machine by its number, elsewhere by a day's age, for there are network file systems whose locks reach no further than one machine.
 * What another user owns is left alone. Creator and remover may meet: so the creator locks first and then looks whether the file is still
 * there, and the remover removes while it holds the lock.
 */
public final class TemporaryFile implements Closeable {
    private static final Pattern NAME =
            Pattern.compile("\\.enlightenment-([0-9a-f]{1,8})-(\\d{1,18})-[0-9a-f]{1,16}\\.tmp");
    private static final String GLOB = ".enlightenment-*.tmp";
    private static final String FOLDER = ".d";
    private static final Set<PosixFilePermission> OWNER = PosixFilePermissions.fromString("rwx------");
    private static final Duration LONG_AGO = Duration.ofDays(1);

    /** Names in use by this process, whose own locks do not stop it. */
    private static final Set<String> IN_USE = ConcurrentHashMap.newKeySet();

    private static final Set<Path> CLEANED = ConcurrentHashMap.newKeySet();

    private final Path file;
    private final FileChannel channel;
    private Path folder;

    private TemporaryFile(Path file, FileChannel channel) {
        this.file = file;
        this.channel = channel;
    }

    /**
     * Makes an empty file.
     *
     * @param folder where what it becomes will be
     * @param attributes what it is born with; without any, its permissions are those of other new files
     */
    public static TemporaryFile in(Path folder, FileAttribute<?>... attributes) throws IOException {
        while (true) {
            String name = reserveName();
            Path file = folder.resolve(name);
            FileChannel channel = null;
            boolean ours = false;
            try {
                channel = FileChannel.open(
                        file, EnumSet.of(StandardOpenOption.CREATE_NEW, StandardOpenOption.WRITE), attributes);
                ours = lock(channel) && Files.exists(file, LinkOption.NOFOLLOW_LINKS);
                if (ours) {
                    return new TemporaryFile(file, channel);
                }
            } finally {
                if (!ours) {
                    IN_USE.remove(name);
                    if (channel != null) {
                        channel.close();
                    }
                }
            }
        }
    }

    /** A new name of a file that {@link #clean} leaves alone as long as this process lives. */
    static String reserveName() {
        String name = ".enlightenment-" + HostTag.HASH + "-"
                + ProcessHandle.current().pid() + "-"
                + Long.toHexString(ThreadLocalRandom.current().nextLong()) + ".tmp";
        IN_USE.add(name);
        return name;
    }

    /** Locks a file; false if another process is just removing it. Where there are no locks, no process removes files. */
    private static boolean lock(FileChannel channel) {
        try {
            return channel.tryLock() != null;
        } catch (IOException e) {
            return true;
        }
    }

    /** Receives what the file is to hold. */
    public OutputStream stream() {
        return Channels.newOutputStream(channel);
    }

    /** Lets what was written reach the disk. */
    public void force() throws IOException {
        channel.force(true);
    }

    /**
     * A folder beside the file, which goes with it; for tools that want to make their files themselves. Only the owner may look
     * into it, as far as the file system knows permissions.
     */
    public Path folder() throws IOException {
        if (folder == null) {
            boolean posix = Files.getFileStore(file).supportsFileAttributeView("posix");
            FileAttribute<?>[] attributes = posix
                    ? new FileAttribute<?>[] {PosixFilePermissions.asFileAttribute(OWNER)}
                    : new FileAttribute<?>[0];
            folder = Files.createDirectory(folderOf(file), attributes);
        }
        return folder;
    }

    private static Path folderOf(Path file) {
        return file.resolveSibling(file.getFileName() + FOLDER);
    }

    /** Becomes this file, in the place of what is there, in one step as far as the file system can. */
    public void replace(Path target) throws IOException {
        try {
            Files.move(file, target, StandardCopyOption.ATOMIC_MOVE);
        } catch (AtomicMoveNotSupportedException e) {
            Files.move(file, target, StandardCopyOption.REPLACE_EXISTING);
        }
    }

    /**
     * Becomes this file.
     *
     * @throws java.nio.file.FileAlreadyExistsException if it is there
     */
    public void become(Path target) throws IOException {
        Files.move(file, target);
    }

    /** Removes the file, unless it has become another one, and its folder. */
    @Override
    public void close() throws IOException {
        try (channel) {
            remove(file);
        } finally {
            IN_USE.remove(file.getFileName().toString());
        }
    }

    private static void remove(Path file) throws IOException {
        Path folder = folderOf(file);
        if (Files.isDirectory(folder, LinkOption.NOFOLLOW_LINKS)
                && owner(folder).equals(owner(file))) {
            try (DirectoryStream<Path> all = Files.newDirectoryStream(folder)) {
                for (Path inner : all) {
                    Files.deleteIfExists(inner);
                }
            }
            Files.deleteIfExists(folder);
        }
        Files.deleteIfExists(file);
    }

    /** As {@link #clean}, for the first time that this process writes there. */
    static void cleanOnce(Path folder) {
        if (CLEANED.add(folder)) {
            clean(folder);
        }
    }

    /** Removes what processes that are dead have left in a folder; what cannot be removed stays. */
    public static void clean(Path folder) {
        try {
            List<Path> left = left(folder);
            if (!left.isEmpty()) {
                removeOurs(folder, left);
            }
        } catch (IOException | DirectoryIteratorException | UnsupportedOperationException e) {
            // Cleaning is optional: a process that cannot write to the folder fails later, when it matters.
            return;
        }
    }

    private static List<Path> left(Path folder) throws IOException {
        List<Path> left = new ArrayList<>();
        try (DirectoryStream<Path> all = Files.newDirectoryStream(folder, GLOB)) {
            for (Path file : all) {
                Matcher name = NAME.matcher(file.getFileName().toString());
                if (name.matches() && !IN_USE.contains(name.group()) && mayBeDead(file, name)) {
                    left.add(file);
                }
            }
        }
        return left;
    }

    /** Leaves alone what belongs to others: in a folder for everybody they might exchange it while it is looked at. */
    private static void removeOurs(Path folder, List<Path> left) throws IOException {
        UserPrincipal us;
        try (TemporaryFile own = in(folder)) {
            us = owner(own.file);
        }
        for (Path file : left) {
            if (owner(file).equals(us)) {
                removeUnlessLocked(file);
            }
        }
    }

    private static UserPrincipal owner(Path file) throws IOException {
        return Files.getOwner(file, LinkOption.NOFOLLOW_LINKS);
    }

    private static boolean mayBeDead(Path file, Matcher name) throws IOException {
        if (!name.group(1).equals(HostTag.HASH)) {
            Instant changed =
                    Files.getLastModifiedTime(file, LinkOption.NOFOLLOW_LINKS).toInstant();
            return changed.plus(LONG_AGO).isBefore(Instant.now());
        }
        // Our own number may have been another's before, as in containers: there the lock alone tells.
        long process = Long.parseLong(name.group(2));
        return process == ProcessHandle.current().pid()
                || !ProcessHandle.of(process).map(ProcessHandle::isAlive).orElse(false);
    }

    private static void removeUnlessLocked(Path file) {
        try (FileChannel channel = FileChannel.open(file, StandardOpenOption.WRITE, LinkOption.NOFOLLOW_LINKS);
                FileLock lock = channel.tryLock()) {
            if (lock != null) {
                remove(file);
            }
        } catch (IOException | OverlappingFileLockException e) {
            // Somebody else's, or gone just now.
            return;
        }
    }
}
