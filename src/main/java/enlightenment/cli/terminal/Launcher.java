package enlightenment.cli.terminal;

import java.io.File;

/** The name by which this program was called: the beginning of commands that the user may copy. */
public final class Launcher {
    /** The system property in which the launcher of the application tells the name or path that it was called by. */
    static final String PROPERTY = "enlightenment.launcher";

    private Launcher() {}

    /** The words before the name of a command, as a shell reads them. */
    public static String command() {
        return command(System.getProperty(PROPERTY), System.getProperty("java.class.path", ""));
    }

    /** @param launcher null or empty where it was not the launcher that started this program */
    static String command(String launcher, String classPath) {
        if (launcher != null && !launcher.isEmpty()) {
            return Shell.quoted(launcher);
        }
        // For java -jar the class path is the jar. Anything else is how developers start it.
        boolean isJar = classPath.endsWith(".jar") && classPath.indexOf(File.pathSeparatorChar) < 0;
        return isJar ? "java -jar " + Shell.quoted(classPath) : "enlightenment";
    }
}
