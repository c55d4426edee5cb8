package enlightenment.text;

import java.io.IOException;

/** Failures of what has a name, some of which say that name and some not. */
public final class FailureText {
    private FailureText() {}

    /**
     * What went wrong, with the name once: {@code store s.db: REASON}, also where the failure says {@code s.db: REASON}.
     *
     * @param name what it is called, or its kind and that
     * @param failure of I/O failures the text has the message only, of unexpected ones the class too
     */
    public static String of(String name, Throwable failure) {
        String why = failure instanceof IOException && failure.getMessage() != null
                ? failure.getMessage()
                : failure.toString();
        int end = why.indexOf(": ");
        String there = end < 0 ? "" : why.substring(0, end);
        boolean isNamed = end > 0 && (name.equals(there) || name.endsWith(" " + there));
        return name + ": " + (isNamed ? why.substring(end + 2) : why);
    }
}
