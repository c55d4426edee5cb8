package enlightenment.cli;

import java.nio.file.Path;

/** Standard input and output where a file is named: both are called {@code -}; a file of that name is {@code ./-}. */
final class StandardStreams {
    /** What messages call standard input. */
    static final String INPUT = "standard input";

    private StandardStreams() {}

    /** Whether this names standard input or output rather than a file. */
    static boolean isNamed(Path file) {
        return file.toString().equals("-");
    }

    /** What messages call an output. */
    static String outputName(Path file) {
        return isNamed(file) ? "standard output" : file.toString();
    }
}
