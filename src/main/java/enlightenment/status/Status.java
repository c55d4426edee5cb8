package enlightenment.status;

import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;

/**
 * The immutable state of a render at one moment, for people and scripts.
 *
 * @param title the title of what is rendered; may be empty, and may come from a scene
 * @param state the state of the render
 * @param done number of units done, of {@code total}
 * @param total number of units in all; 0 as long as that is not known
 * @param unit name of these units, such as pixels
 * @param elapsedSeconds since it began
 * @param remainingSeconds expected time to the end; empty if there is no estimate
 * @param picture the number of the picture so far: another picture has another number; 0 as long as there is none
 * @param statistics further figures, by name: texts, numbers, truth values, lists and maps of such; numbers that are not finite are not
 *     known
 * @param notes the last events, the oldest first
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

    /** An event in words, this many seconds after the start. */
    public record Note(double seconds, String text) {}

    /** The share that is done in per cent, rounded down; 0 as long as the total is not known. */
    public int percent() {
        return total == 0 ? 0 : (int) (100.0 * done / total);
    }
}
