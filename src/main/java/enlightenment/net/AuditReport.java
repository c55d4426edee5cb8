package enlightenment.net;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;

/**
 * Which audits of what a server made were made: tiles that a second machine, or the server, has rendered too.
 *
 * @param due how many tiles were to be rendered by two; those of the server's own are not among them
 * @param missing how many of these rest on the word of one machine, as no other was there
 * @param isOfFilm whether {@code where} has frames
 * @param where the numbers of the tiles that are missing, in ascending order; of a film those of the frames that have any
 */
public record AuditReport(int due, int missing, boolean isOfFilm, List<Integer> where) {
    /** Nothing was to be audited. */
    public static final AuditReport NONE = new AuditReport(0, 0, false, List.of());

    /** As many numbers as a line of a log has room for. */
    private static final int MOST_SHOWN = 20;

    /** {@code where} may not be null. */
    public AuditReport {
        where = List.copyOf(where);
    }

    /** The report of one picture. */
    static AuditReport ofTiles(List<Integer> due, List<Integer> missing) {
        return new AuditReport(due.size(), missing.size(), false, missing);
    }

    /** Whether a second machine has rendered all that it was to. */
    public boolean isComplete() {
        return missing == 0;
    }

    /** What is missing, as a sentence without full stop: {@code 2 of 9 audits were not made: nobody ...}. */
    public String sentence() {
        List<String> shown = new ArrayList<>(
                where.stream().limit(MOST_SHOWN).map(String::valueOf).toList());
        if (where.size() > MOST_SHOWN) {
            shown.add("and " + (where.size() - MOST_SHOWN) + " more");
        }
        String noun = (isOfFilm ? "frame" : "tile") + (where.size() == 1 ? " " : "s ");
        return missing + " of " + due + (due == 1 ? " audit was" : " audits were")
                + " not made: no second machine checked " + (isOfFilm ? "tiles of " : "") + noun
                + shown.stream().collect(Collectors.joining(", "));
    }
}
