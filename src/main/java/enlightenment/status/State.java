package enlightenment.status;

import java.util.Locale;

/** The state of a render. */
public enum State {
    /** No pixel of the picture is there yet. */
    PREPARING,
    RENDERING,
    /** The picture is whole. */
    FINISHED,
    /** The render ended before the picture was whole. */
    STOPPED;

    /** As scripts and pages read it. */
    public String word() {
        return name().toLowerCase(Locale.ROOT);
    }

    /** Whether nothing more will come. */
    public boolean isOver() {
        return this == FINISHED || this == STOPPED;
    }
}
