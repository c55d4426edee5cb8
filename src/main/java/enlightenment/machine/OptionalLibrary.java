package enlightenment.machine;

/** Libraries and modules that a program which embeds this one may leave out. */
public final class OptionalLibrary {
    private OptionalLibrary() {}

    /** Whether a class of this name can be used. */
    public static boolean isPresent(String className) {
        try {
            Class.forName(className, false, OptionalLibrary.class.getClassLoader());
            return true;
        } catch (ClassNotFoundException | LinkageError e) {
            return false;
        }
    }

    /**
     * Fails with a message that tells what to add, where a class is missing.
     *
     * @param className a class of the library
     * @param purpose what needs it, as the beginning of a sentence
     * @param coordinates the library as build tools name it
     * @throws IllegalStateException if there is no such class
     */
    public static void require(String className, String purpose, String coordinates) {
        if (!isPresent(className)) {
            throw new IllegalStateException(
                    purpose + " needs the library " + coordinates + ", which is on neither class path nor module path");
        }
    }
}
