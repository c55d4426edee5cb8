package enlightenment.net;

import java.util.ArrayList;
import java.util.List;

/**
 * Audits that were to be made, and those that were not, as {@code RenderServer.AuditReport} has them.
 *
 * @param due how many tiles were to be rendered by two
 * @param missing how many of these rest on the word of one machine
 * @param isOfFilm whether {@code where} has frames
 * @param where the numbers of the tiles or frames that are missing, in ascending order
 */
record AuditCount(int due, int missing, boolean isOfFilm, List<Integer> where) {
    /** The count of a render without audits. */
    static final AuditCount NONE = new AuditCount(0, 0, false, List.of());

    /** As many numbers as a line of a log has room for. */
    private static final int MOST_SHOWN = 20;

    /** The count of the tiles of one picture. */
    static AuditCount ofTiles(List<Integer> due, List<Integer> missing) {
        return new AuditCount(due.size(), missing.size(), false, missing);
    }

    /** The missing audits as a sentence without full stop. */
    String sentence() {
        List<String> shown = new ArrayList<>(
                where.stream().limit(MOST_SHOWN).map(String::valueOf).toList());
        if (where.size() > MOST_SHOWN) {
            shown.add("and " + (where.size() - MOST_SHOWN) + " more");
        }
        String noun = (isOfFilm ? "frame" : "tile") + (where.size() == 1 ? " " : "s ");
        return missing + " of " + due + (due == 1 ? " audit was" : " audits were")
                + " not made: no second machine checked " + (isOfFilm ? "tiles of " : "") + noun
                + String.join(", ", shown);
    }
}
