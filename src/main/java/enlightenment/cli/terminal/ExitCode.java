package enlightenment.cli.terminal;

/** Exit codes of the process. */
public final class ExitCode {
    /** The command has succeeded. */
    public static final int DONE = 0;

    /** The command was used correctly, but failed. */
    public static final int FAILED = 1;

    /** The command line or the scene has to be changed. */
    public static final int WRONG_INPUT = 2;

    private ExitCode() {}
}
