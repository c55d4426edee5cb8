package enlightenment.scene.json;

import enlightenment.color.DisplayRgb;
import enlightenment.math.Check.InvalidValueException;
import enlightenment.math.Point;
import enlightenment.math.Vec3;
import java.util.Arrays;
import java.util.List;

/**
 * The keys of one object of a document. Records what is missing, unknown or of the wrong type; {@link #sound()} says
 * whether the values that were read may be used.
 */
final class Fields {
    final Node.Obj object;
    private final Values values;
    private final Problems problems;
    private int failuresBefore;

    /** @param object what is read; its keys are checked by {@link #only} */
    Fields(Node.Obj object, Values values) {
        this.object = object;
        this.values = values;
        this.problems = values.problems;
        this.failuresBefore = problems.failures();
    }

    /**
     * Refuses all keys but these.
     *
     * @param what the object in words, with an article: "a sphere"
     */
    Fields only(String what, String... keys) {
        return onlyExcept(new String[0], what, keys);
    }

    /** Refuses all keys but these, and is silent about some that were dealt with. */
    Fields onlyExcept(String[] silent, String what, String... keys) {
        for (int i = 0; i < object.size(); i++) {
            if (!contains(keys, object.key(i)) && !contains(silent, object.key(i))) {
                String found = object.key(i);
                problems.atKey(
                        object,
                        i,
                        Node.quote(found) + " is no key of " + what + "; its keys are " + Values.list(keys)
                                + problems.suggestion(found, Arrays.asList(keys)));
            }
        }
        return this;
    }

    private static boolean contains(String[] keys, String key) {
        for (String k : keys) {
            if (k.equals(key)) {
                return true;
            }
        }
        return false;
    }

    /** Whether everything since the beginning or the last {@link #restart} went well. */
    boolean sound() {
        return problems.failures() == failuresBefore;
    }

    void restart() {
        failuresBefore = problems.failures();
    }

    boolean has(String key) {
        return object.indexOf(key) >= 0;
    }

    /** The value of a key that may be missing, then null. */
    Node optional(String key) {
        return object.get(key);
    }

    /** The value of a key that must not be missing; null, and a problem, where it is. */
    Node required(String key, String what) {
        Node node = object.get(key);
        if (node == null) {
            problems.at(object, Node.escape(key), "is missing; expected " + what);
        }
        return node;
    }

    double number(String key) {
        Node node = required(key, "a number");
        return node == null ? Double.NaN : values.number(node);
    }

    double number(String key, double fallback) {
        Node node = object.get(key);
        return node == null ? fallback : values.number(node);
    }

    /** A whole number that must not be missing. */
    int whole(String key, int lo, int hi) {
        Node node = required(key, "a whole number in " + lo + ".." + hi);
        return node == null ? 0 : (int) values.whole(node, lo, hi);
    }

    /** A whole number, or the fallback where it is missing. */
    long whole(String key, long lo, long hi, long fallback) {
        Node node = object.get(key);
        return node == null ? fallback : values.whole(node, lo, hi);
    }

    boolean truth(String key, boolean fallback) {
        Node node = object.get(key);
        return node == null ? fallback : values.truth(node);
    }

    String string(String key, String fallback) {
        Node node = object.get(key);
        return node == null ? fallback : values.string(node);
    }

    /** One of a few words, or the first of them where the key is missing; null where it is none of them. */
    String word(String key, String what, String... words) {
        Node node = object.get(key);
        return node == null ? words[0] : values.word(node, what, words);
    }

    /** One of a few words, for a key that must not be missing; null where it is none of them. */
    String requiredWord(String key, String what, String... words) {
        Node node = required(key, what + ": " + Values.list(words));
        return node == null ? null : values.word(node, what, words);
    }

    Point point(String key) {
        Node node = required(key, "a point [x, y, z]");
        return node == null ? null : values.point(node);
    }

    /** Several points. Never null; without use where {@link #sound()} is false. */
    Point[] points(String key, int count, String what) {
        Node node = required(key, what);
        Point[] points = node == null ? null : values.points(node, count, what);
        return points == null ? new Point[count] : points;
    }

    Vec3 direction(String key) {
        String what = "a direction [x, y, z]";
        Node node = required(key, what);
        return node == null ? null : values.vector(node, what);
    }

    DisplayRgb color(String key) {
        Node node = required(key, "a colour, \"#rrggbb\" or [r, g, b] with components in 0..1");
        return node == null ? null : values.color(node);
    }

    DisplayRgb color(String key, DisplayRgb fallback) {
        Node node = object.get(key);
        return node == null ? fallback : values.color(node);
    }

    /** The values of an array, or none where the key is missing. */
    List<Node> list(String key, String what) {
        Node node = object.get(key);
        List<Node> list = node == null ? null : values.array(node, what);
        return list == null ? List.of() : list;
    }

    /** Turns a value that a constructor refused into a problem at its place. */
    void refuse(InvalidValueException e) {
        problems.at(object, e.key(), e.getMessage());
    }
}
