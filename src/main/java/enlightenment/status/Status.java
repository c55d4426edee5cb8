package enlightenment.status;

import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;

/**
 * The immutable state of a render at one moment, for people and scripts.
 *
 * @param title the title of the render; may be empty, and may come from a scene
 * @param state the state of the render
 * @param done number of units done, of {@code total}
 * @param total number of units in all; 0 until it is known
 * @param unit name of these units, such as pixels
 * @param elapsedSeconds seconds since the render began
 * @param remainingSeconds expected time to the end; empty if there is no estimate
 * @param picture number of the current picture, which differs for each picture; 0 if there is none yet
 * @param statistics further figures by name: texts, numbers, booleans, lists and maps of such; numbers that are not finite are unknown
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

    /** An event in words, with its time in seconds after the start. */
    public record Note(double seconds, String text) {}

    /** The finished share in per cent, rounded down; 0 until the total is known. */
    public int percent() {
        return total == 0 ? 0 : (int) (100.0 * done / total);
    }
}
