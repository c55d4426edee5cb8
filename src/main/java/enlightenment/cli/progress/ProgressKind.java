package enlightenment.cli.progress;

import enlightenment.cli.option.WordOption;
import java.util.List;
import java.util.Locale;

/** The ways to show progress. */
public enum ProgressKind {
    /** {@link #BAR} on a terminal, else {@link #PLAIN}. */
    AUTO,
    /** A bar that is drawn again and again in one line, with the time that remains. */
    BAR,
    /** A line of text now and then, for log files. */
    PLAIN,
    NONE;

    @Override
    public String toString() {
        return name().toLowerCase(Locale.ROOT);
    }

    static final class Words extends WordOption<ProgressKind> {
        Words() {
            super(List.of(values()));
        }
    }
}
