package enlightenment.file;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.UnknownHostException;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystemException;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;

/** Failures of reading and writing, with messages that name the file or host. */
public final class FileFailure {
    private FileFailure() {}

    /**
     * The failure itself if it names a file, as those of opening do; else one that names this file. What fails later, as reading a
     * folder or writing to a full disk, names none.
     */
    public static IOException named(Path file, IOException e) {
        return e instanceof FileSystemException f && f.getFile() != null ? e : because(file, reason(e), e);
    }

    /** A failure that names the file: its message is {@code FILE: REASON}. */
    public static FileSystemException because(Path file, String reason) {
        return new FileSystemException(file.toString(), null, reason);
    }

    private static FileSystemException because(Path file, String reason, IOException cause) {
        FileSystemException named = because(file, reason);
        named.initCause(cause);
        return named;
    }

    /** Why something failed, in words and without the name of any file. */
    public static String reason(IOException e) {
        if (e instanceof NoSuchFileException) {
            return "there is no such file";
        }
        if (e instanceof AccessDeniedException) {
            return "permission denied";
        }
        if (e instanceof FileAlreadyExistsException) {
            return "it exists already";
        }
        if (e instanceof UnknownHostException && e.getMessage() != null) {
            // The bare name, or the name and what the system said.
            return "the host " + e.getMessage().replaceFirst(": .*", "") + " is not known";
        }
        String said = e instanceof FileSystemException f ? f.getReason() : e.getMessage();
        return said == null ? e.getClass().getSimpleName() : said;
    }

    /** What went wrong, with the file where the failure tells it: {@code FILE: REASON}. */
    public static String described(IOException e) {
        return e instanceof FileSystemException f && f.getFile() != null ? f.getFile() + ": " + reason(e) : reason(e);
    }

    /** The message of a failure that ended a render: that of I/O failures; with the class for unexpected ones. */
    public static String told(Throwable failure) {
        boolean isWrapped = failure instanceof UncheckedIOException
                && failure.getCause().toString().equals(failure.getMessage());
        Throwable plain = isWrapped ? failure.getCause() : failure;
        boolean isExpected = plain instanceof IOException || plain instanceof UncheckedIOException;
        return isExpected && plain.getMessage() != null ? plain.getMessage() : plain.toString();
    }
}
