package enlightenment.scene.json;

import enlightenment.scene.SceneException;
import enlightenment.scene.SceneException.Problem;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

/** Collects what is wrong with a document. */
final class Problems {
    /** Edit distances cost time; whoever makes more mistakes than this has seen the pattern. */
    private static final int MOST_SUGGESTIONS = 200;

    private final String file;
    private final String frame;
    private final List<Problem> problems = new ArrayList<>();
    private int suggestions;
    private int failures;

    /**
     * @param file the name to show for the file
     * @param frame the frame that is read, or null
     */
    Problems(String file, Integer frame) {
        this.file = file;
        this.frame = frame == null ? "" : " (in frame " + frame + " of the animation)";
    }

    /** How often something failed so far; what is made of failed values must not be made. */
    int failures() {
        return failures;
    }

    /** Counts a failure whose problem is already on record. */
    void fail() {
        failures++;
    }

    /** A problem with a value. */
    void at(Node node, String message) {
        boolean animated = node instanceof Node.Num && ((Node.Num) node).animated;
        add(node.line, node.column, node.pointer(), animated ? message + frame : message);
    }

    /**
     * A problem with a part of a value, which may be missing.
     *
     * @param path a relative JSON pointer without the leading slash; "" for the value itself
     */
    void at(Node node, String path, String message) {
        Node place = node;
        String rest = path;
        while (!rest.isEmpty()) {
            int slash = rest.indexOf('/');
            Node next = place.child(slash < 0 ? rest : rest.substring(0, slash));
            if (next == null) {
                add(place.line, place.column, place.pointer() + "/" + rest, message);
                return;
            }
            place = next;
            rest = slash < 0 ? "" : rest.substring(slash + 1);
        }
        at(place, message);
    }

    /** A problem with the key of a value. */
    void atKey(Node.Obj object, int i, String message) {
        add(object.keyLine(i), object.keyColumn(i), object.value(i).pointer(), message);
    }

    void add(int line, int column, String pointer, String message) {
        failures++;
        problems.add(new Problem(file, line, column, pointer, message));
    }

    /** The words "; did you mean …?" where one of the names is near the one found, otherwise "". */
    String suggestion(String found, Iterable<String> names) {
        if (suggestions++ >= MOST_SUGGESTIONS) {
            return "";
        }
        String nearest = Suggestions.nearest(found, names);
        return nearest == null ? "" : "; did you mean \"" + nearest + "\"?";
    }

    /** Fails if there are any problems. */
    void throwIfAny() {
        if (problems.isEmpty()) {
            return;
        }
        List<Problem> sorted = new ArrayList<>(problems);
        sorted.sort(Comparator.comparingInt(Problem::line).thenComparingInt(Problem::column));
        throw new SceneException(sorted);
    }
}
