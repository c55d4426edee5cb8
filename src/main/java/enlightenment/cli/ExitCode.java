package enlightenment.cli;

/** What the process tells its caller when it ends. */
final class ExitCode {
    /** All went well. */
    static final int DONE = 0;

    /** What was asked for is sound, but could not be done. */
    static final int FAILED = 1;

    /** The command line or the scene has to be changed. */
    static final int WRONG_INPUT = 2;

    private ExitCode() {}
}
