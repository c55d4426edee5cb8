package enlightenment.cli;

import java.io.PrintStream;

/**
 * Where a command writes to and what can stop it.
 *
 * @param out results
 * @param err messages and progress
 * @param stop tells when the user wants a render to end
 */
record Terminal(PrintStream out, PrintStream err, Stop stop) {

    /** One message for the user. */
    void say(String message) {
        err.println("enlightenment: " + message);
    }
}
