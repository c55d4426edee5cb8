package enlightenment.cli;

import java.nio.file.Path;

/** Standard input and output as files: both are called {@code -}; a file of that name is {@code ./-}. */
final class Standard {
    private Standard() {}

    /** Whether this names no file but standard input or output. */
    static boolean is(Path file) {
        return file.toString().equals("-");
    }

    /** What messages call an output. */
    static String output(Path file) {
        return is(file) ? "standard output" : file.toString();
    }
}
