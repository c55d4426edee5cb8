package enlightenment.cli.terminal;

/** What the process tells its caller when it ends. */
public final class ExitCode {
    /** All went well. */
    public static final int DONE = 0;

    /** What was asked for is sound, but could not be done. */
    public static final int FAILED = 1;

    /** The command line or the scene has to be changed. */
    public static final int WRONG_INPUT = 2;

    private ExitCode() {}
}
