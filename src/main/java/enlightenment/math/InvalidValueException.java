package enlightenment.math;

/**
 * Thrown for a value that a scene or a setting cannot have, by the constructors of descriptions. The message is {@code KEY: PROBLEM}, such as
 * {@code radius: must be a number greater than 0, not -1.0}.
 */
public final class InvalidValueException extends IllegalArgumentException {
    private static final long serialVersionUID = 1L;
    private final String key;
    private final String problem;

    /**
     * An exception for one value.
     *
     * @param key where the value is, see {@link #key}; "" if the problem concerns the whole that the message is about
     * @param problem what is wrong with it, see {@link #problem}
     */
    public InvalidValueException(String key, String problem) {
        super(key.isEmpty() ? problem : key + ": " + problem);
        this.key = key;
        this.problem = problem;
    }

    /** The key of the scene format that holds the value, as a JSON pointer relative to the description, without its slash. */
    public String key() {
        return key;
    }

    /** What is wrong, without the key: for a caller that names the place in another way. */
    public String problem() {
        return problem;
    }
}
