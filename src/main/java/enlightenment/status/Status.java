package enlightenment.status;

import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;

/**
 * How far a render is, for people and scripts: one moment of it, which never changes.
 *
 * @param title what is rendered; may be empty, and may come from a scene
 * @param state where it is
 * @param done how much of it is done, of {@code total}
 * @param total how much there is to do; 0 as long as that is not known
 * @param unit what is counted, such as pixels
 * @param elapsedSeconds since it began
 * @param remainingSeconds expected time to the end; empty if there is no estimate
 * @param picture the number of the picture so far: another picture has another number; 0 as long as there is none
 * @param statistics what else is known, by name: texts, numbers, truth values, lists and maps of such; numbers that are not finite are
 *     not known
 * @param notes what happened, the oldest first
 */
public record Status(
        String title,
        State state,
        long done,
        long total,
        String unit,
        double elapsedSeconds,
        OptionalDouble remainingSeconds,
        long picture,
        Map<String, ?> statistics,
        List<Note> notes) {

    /** Something that happened, this many seconds after the start. */
    public record Note(double seconds, String text) {}

    /** How much is done of a hundred, rounded down; 0 as long as that is not known. */
    public int percent() {
        return total == 0 ? 0 : (int) (100.0 * done / total);
    }
}
