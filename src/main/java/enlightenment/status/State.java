package enlightenment.status;

import java.util.Locale;

/** The state of a render. */
public enum State {
    /** Before the first pixel of the picture. */
    PREPARING,
    RENDERING,
    /** The picture is complete. */
    FINISHED,
    /** The render ended before the picture was complete. */
    STOPPED;

    /** The name of the state in lower case, for scripts and pages. */
    public String word() {
        return name().toLowerCase(Locale.ROOT);
    }

    /** Whether the render has ended. */
    public boolean isOver() {
        return this == FINISHED || this == STOPPED;
    }
}
