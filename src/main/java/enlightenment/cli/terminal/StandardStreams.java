package enlightenment.cli.terminal;

import enlightenment.file.FileFailure;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

/** Standard input and output where a file is named: both are called {@code -}; a file of that name is {@code ./-}. */
public final class StandardStreams {
    /** The name of standard input in messages. */
    public static final String INPUT = "standard input";

    /** Names of what descriptor 0 of this process is open on, where the operating system has such names. */
    private static final List<Path> DESCRIPTOR = List.of(Path.of("/proc/self/fd/0"), Path.of("/dev/fd/0"));

    private StandardStreams() {}

    /** The file that standard input reads; empty if it is none (a terminal, a pipe), or that cannot be found out. */
    public static Optional<Path> inputFile() {
        return DESCRIPTOR.stream().filter(Files::isRegularFile).findFirst();
    }

    /**
     * All bytes of standard input.
     *
     * @throws CliException if they cannot be read
     */
    public static byte[] readInput(Terminal terminal) {
        if (isInputClosed()) {
            throw CliException.failed("cannot read " + INPUT + ": it is closed");
        }
        try {
            return terminal.in().readAllBytes();
        } catch (IOException e) {
            throw CliException.failed("cannot read " + INPUT + ": " + FileFailure.described(e));
        }
    }

    /** Whether the process was started without standard input: the first file that Java opens, one of its own, then has its number. */
    private static boolean isInputClosed() {
        Optional<Path> file = inputFile();
        try {
            return file.isPresent()
                    && file.get()
                            .toRealPath()
                            .startsWith(Path.of(System.getProperty("java.home")).toRealPath());
        } catch (IOException e) {
            // Where it cannot be found out, reading tells.
            return false;
        }
    }

    /** Whether this names standard input or output rather than a file. */
    public static boolean isNamed(Path file) {
        return file.toString().equals("-");
    }

    /** The name of an output in messages. */
    public static String outputName(Path file) {
        return isNamed(file) ? "standard output" : file.toString();
    }
}
