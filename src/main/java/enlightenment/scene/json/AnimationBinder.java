package enlightenment.scene.json;

import enlightenment.math.Check.InvalidValueException;
import enlightenment.scene.Animation;
import enlightenment.scene.Animation.Track;
import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.NavigableMap;
import java.util.Set;
import java.util.TreeMap;

/** Reads the animation and, for a frame of it, replaces the numbers that its tracks name. */
final class AnimationBinder {
    /** More than any double needs to tell a number from its neighbours. */
    private static final MathContext QUOTIENT = new MathContext(40, RoundingMode.HALF_EVEN);

    private final Node root;
    private final Values values;
    private final Problems problems;
    private final Integer frame;
    private final Set<Node> targets = new HashSet<>();

    /** @param frame the frame to read, or null to leave the document's numbers as they are */
    AnimationBinder(Node root, Values values, Integer frame) {
        this.root = root;
        this.values = values;
        this.problems = values.problems;
        this.frame = frame;
    }

    /** The animation, or null after a problem. */
    Animation read(Node node) {
        Node.Obj o = values.object(node, "an animation (an object)");
        if (o == null) {
            return null;
        }
        Fields f = new Fields(o, values).only("an animation", "frames", "framesPerSecond", "tracks");
        int frames = f.whole("frames", 1, Integer.MAX_VALUE);
        double framesPerSecond = f.number("framesPerSecond", 25);
        if (frame != null && frames > 0 && (frame < 0 || frame >= frames)) {
            problems.at(o, "frames", "has the frames 0.." + (frames - 1) + ", but no frame " + frame);
        }
        List<Track> tracks = new ArrayList<>();
        for (Node track : f.list("tracks", "an array of tracks")) {
            Node.Obj t = values.object(track, "a track (an object)");
            Track read = t == null ? null : track(t, node);
            if (read != null) {
                tracks.add(read);
            }
        }
        try {
            return f.sound() ? new Animation(frames, framesPerSecond, tracks) : null;
        } catch (InvalidValueException e) {
            f.refuse(e);
            return null;
        }
    }

    private Track track(Node.Obj o, Node animation) {
        Fields f = new Fields(o, values).only("a track", "target", "keys");
        Node keys = f.required("keys", "an object of frames and values");
        NavigableMap<Integer, BigDecimal> at = keys == null ? null : keys(keys);
        Node target = f.required("target", "a JSON pointer to a number of this file");
        String pointer = target == null ? null : values.string(target);
        Node.Num number = pointer == null ? null : number(target, pointer, animation);
        if (!f.sound() || number == null) {
            return null;
        }
        if (frame != null && !number.bad) {
            String text = value(at, frame).toString();
            String problem = Numbers.problem(text);
            number.text = problem == null ? text : number.text;
            number.animated = true;
            number.bad = problem != null;
            if (problem != null) {
                problems.at(number, problem);
            }
        }
        try {
            return new Track(pointer, at);
        } catch (InvalidValueException e) {
            f.refuse(e);
            return null;
        }
    }

    private NavigableMap<Integer, BigDecimal> keys(Node node) {
        Node.Obj o = values.object(node, "an object of frames and values, like { \"0\": 1, \"10\": 2.5 }");
        NavigableMap<Integer, BigDecimal> keys = new TreeMap<>();
        for (int i = 0; o != null && i < o.size(); i++) {
            Integer at = frame(o.key(i));
            if (at == null) {
                problems.atKey(o, i, "must be the whole number of a frame, like \"10\", not " + Node.quote(o.key(i)));
            }
            BigDecimal value = values.decimal(o.value(i));
            if (at != null && value != null) {
                keys.put(at, value);
            }
        }
        if (o != null && o.size() == 0) {
            problems.at(o, "must hold at least one frame and its value, but is empty");
        }
        return keys;
    }

    /** The frame's number; null where the text is not its usual form, so that no frame has two names. */
    private static Integer frame(String text) {
        try {
            Integer value = Integer.valueOf(text);
            return value.toString().equals(text) ? value : null;
        } catch (NumberFormatException e) {
            return null;
        }
    }

    private Node.Num number(Node target, String pointer, Node animation) {
        Node node = root;
        if (!pointer.startsWith("/")) {
            problems.at(
                    target,
                    "must be a JSON pointer to a number of this file, like \"/objects/0/radius\", not "
                            + Node.quote(pointer));
            return null;
        }
        for (int from = 1; from <= pointer.length(); ) {
            int slash = pointer.indexOf('/', from);
            int to = slash < 0 ? pointer.length() : slash;
            String segment = pointer.substring(from, to).replace("~1", "/").replace("~0", "~");
            Node next = node.child(segment);
            if (next == null) {
                problems.at(
                        target,
                        "must point to a number of this file, but " + where(node) + " has no " + Node.quote(segment)
                                + nearest(node, segment));
                return null;
            }
            node = next;
            from = to + 1;
        }
        return number(target, node, animation);
    }

    private Node.Num number(Node target, Node found, Node animation) {
        if (!(found instanceof Node.Num)) {
            problems.at(target, "must point to a number of this file, not to " + found.describe());
            return null;
        }
        for (Node n = found; n != null; n = n.parent) {
            if (n == animation) {
                problems.at(target, "must point to a number of the scene, not of its animation");
                return null;
            }
        }
        if (!targets.add(found)) {
            problems.at(target, "must be a number that no other track changes");
            return null;
        }
        return (Node.Num) found;
    }

    private static String where(Node node) {
        return node.parent == null ? "the scene" : "\"" + node.pointer() + "\"";
    }

    private String nearest(Node node, String segment) {
        if (node instanceof Node.Obj) {
            return problems.suggestion(segment, ((Node.Obj) node).keys());
        }
        return node instanceof Node.Arr ? " (it is " + node.describe() + ")" : "";
    }

    /** The value at a frame: linear between the keys around it, constant beyond them. */
    static BigDecimal value(NavigableMap<Integer, BigDecimal> keys, int frame) {
        Map.Entry<Integer, BigDecimal> before = keys.floorEntry(frame);
        Map.Entry<Integer, BigDecimal> after = keys.ceilingEntry(frame);
        if (before == null || after == null) {
            return before == null ? after.getValue() : before.getValue();
        }
        if (before.getKey().equals(after.getKey())) {
            return before.getValue();
        }
        long span = (long) after.getKey() - before.getKey();
        long done = (long) frame - before.getKey();
        BigDecimal change = after.getValue().subtract(before.getValue());
        BigDecimal part = change.multiply(BigDecimal.valueOf(done)).divide(BigDecimal.valueOf(span), QUOTIENT);
        return before.getValue().add(part);
    }
}
