package enlightenment.cli;

/** Something the user has to know; the message is all there is to say. */
final class CliException extends RuntimeException {
    private static final long serialVersionUID = 1L;

    /** All went well. */
    static final int DONE = 0;

    /** What was asked for is sound, but could not be done. */
    static final int FAILED = 1;

    /** The command line or the scene has to be changed. */
    static final int WRONG_INPUT = 2;

    private final int exitCode;

    private CliException(int exitCode, String message) {
        super(message);
        this.exitCode = exitCode;
    }

    /** The command line asks for something that cannot be. */
    static CliException wrongUsage(String message) {
        return new CliException(WRONG_INPUT, message);
    }

    /** The machine does not let us. */
    static CliException failed(String message) {
        return new CliException(FAILED, message);
    }

    int exitCode() {
        return exitCode;
    }
}
