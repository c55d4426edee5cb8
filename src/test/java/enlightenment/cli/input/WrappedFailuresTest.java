package enlightenment.cli.input;

import static org.junit.jupiter.api.Assertions.assertEquals;

import enlightenment.cli.terminal.ExitCode;
import enlightenment.cli.terminal.ShutdownSignal;
import enlightenment.cli.terminal.Terminal;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.io.UncheckedIOException;
import java.nio.file.FileSystemException;
import org.junit.jupiter.api.Test;

/** A disk that is full, and a process that may open no more files, are no internal errors, however Java wraps them. */
class WrappedFailuresTest {
    private static String said(Throwable failure) {
        ByteArrayOutputStream err = new ByteArrayOutputStream();
        PrintStream stream = new PrintStream(err);
        int code = new Failures(new Terminal(stream, stream, new ShutdownSignal())).report(failure);
        assertEquals(ExitCode.FAILED, code);
        return err.toString();
    }

    @Test
    void aFullDiskIsCalledThat() {
        IOException full = new FileSystemException("b.json", null, "No space left on device");
        assertEquals("enlightenment: b.json: No space left on device\n", said(new UncheckedIOException(full)));
    }

    @Test
    void classesThatCannotBeReadAreReportedByTheReason() {
        IOException many = new IOException("Too many open files");
        assertEquals("enlightenment: Too many open files\n", said(new ExceptionInInitializerError(many)));
        assertEquals(
                "enlightenment: Too many open files\n",
                said(new ExceptionInInitializerError(new UncheckedIOException(many))));
    }

    @Test
    void anErrorWithoutSuchAReasonStaysInternal() {
        String said = said(new ExceptionInInitializerError(new IllegalStateException("x")));
        assertEquals(
                "enlightenment: internal error: java.lang.ExceptionInInitializerError"
                        + " (java -Denlightenment.trace=true shows where)\n",
                said);
    }
}
