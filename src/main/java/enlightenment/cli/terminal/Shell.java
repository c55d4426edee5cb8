package enlightenment.cli.terminal;

/** Commands for the user to copy. */
public final class Shell {
    private static final String HARMLESS = "[\\w@%+=:,./-]+";

    private Shell() {}

    /** The text such that a POSIX shell takes it for one word. */
    public static String quoted(String text) {
        return text.matches(HARMLESS) ? text : "'" + text.replace("'", "'\\''") + "'";
    }
}
