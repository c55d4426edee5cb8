package enlightenment.cli.terminal;

/** Ends a command with a message, which is all that the user has to know, and an exit code. */
public final class CliException extends RuntimeException {
    private static final long serialVersionUID = 1L;

    private final int exitCode;

    private CliException(int exitCode, String message) {
        super(message);
        this.exitCode = exitCode;
    }

    /** The command line asks for something that cannot be. */
    public static CliException wrongUsage(String message) {
        return new CliException(ExitCode.WRONG_INPUT, message);
    }

    /** What was asked for is sound, but could not be done. */
    public static CliException failed(String message) {
        return new CliException(ExitCode.FAILED, message);
    }

    public int exitCode() {
        return exitCode;
    }
}
