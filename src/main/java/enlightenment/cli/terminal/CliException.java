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

    /** A failure of a command that was used correctly. */
    public static CliException failed(String message) {
        return new CliException(ExitCode.FAILED, message);
    }

    public int exitCode() {
        return exitCode;
    }
}
