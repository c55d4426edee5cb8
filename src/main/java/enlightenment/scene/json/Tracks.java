package enlightenment.scene.json;

import enlightenment.scene.Animation;
import enlightenment.scene.json.tree.JsonPointer;
import enlightenment.scene.json.tree.JsonValue;
import enlightenment.text.Plain;
import java.math.BigDecimal;
import java.math.BigInteger;
import java.math.RoundingMode;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.NavigableMap;
import java.util.Set;
import java.util.TreeMap;

/**
 * Reads the animation, and applies its tracks to the document at a time.
 *
 * <p>A number between two keys is a fraction. Where it is a decimal, it is kept exactly. Where it is none (a third), it is
 * cut after {@link #DECIMALS} decimals, always downwards. That is as good as keeping the fraction until it is rounded to a
 * double: moved by a decimal, the cut number moves by just that; if two numbers differ by a decimal, so do the cut ones;
 * and a difference that is no decimal is no number halfway between two doubles either, and cannot be so close to one
 * that 10^-1600 matters. (A fraction whose denominator is a product of two lengths of time and 10^k differs from a
 * multiple of 2^-2150, which no double's halves go below even in a scene's frame, by 10^-(k + 666) or not at all. A length of
 * time is the third power of up to 2^40 · 10^20, where a shutter is open and motion is smooth: then it is 10^-(k + 850). That holds for
 * keys and coordinates of up to 700 decimals.)
 */
final class Tracks {
    /** Decimals that are kept of a number between keys that is not a finite decimal. */
    static final int DECIMALS = 1600;

    private static final BigInteger THREE = BigInteger.valueOf(3);
    private static final BigInteger FIVE = BigInteger.valueOf(5);

    private final JsonValue root;
    private final Values values;
    private final Set<List<String>> targets = new HashSet<>();

    Tracks(JsonValue root, Values values) {
        this.root = root;
        this.values = values;
    }

    /** The animation; null after a problem. */
    Animation read(JsonValue v, JsonPointer place) {
        Fields f = Fields.of(v, place, PartKeys.ANIMATION, values);
        if (f == null) {
            return null;
        }
        int frames = f.integer("frames", 1, Integer.MAX_VALUE, 1);
        double framesPerSecond = f.number("framesPerSecond");
        List<Animation.Track> tracks = new ArrayList<>();
        JsonValue t = f.get("tracks");
        JsonValue.Arr a = t == null ? null : values.array(t, f.at("tracks"), -1, "an array of tracks");
        for (int i = 0; a != null && i < a.size(); i++) {
            Fields track = Fields.of(a.get(i), f.at("tracks").child(i), PartKeys.TRACK, values);
            if (track != null) {
                tracks.add(track(track));
            }
        }
        double shutter = f.number("shutter", 0);
        int instants = f.integer("instants", 1, Animation.MOST_INSTANTS, Animation.USUAL_INSTANTS);
        return f.make(() -> new Animation(frames, framesPerSecond, tracks, shutter, instants));
    }

    private Animation.Track track(Fields f) {
        String target = f.text("target", "a JSON pointer such as \"/objects/0/center/1\"");
        if (target != null) {
            checkTarget(f, target);
        }
        NavigableMap<Integer, BigDecimal> keys = new TreeMap<>();
        JsonValue v = f.get("keys");
        JsonValue.Obj o = v == null ? null : values.object(v, f.at("keys"), "values by frames");
        for (int i = 0; o != null && i < o.size(); i++) {
            JsonPointer place = f.at("keys").child(o.key(i));
            if (isFrame(o.key(i))) {
                keys.put(Integer.parseInt(o.key(i)), values.exact(o.value(i), place));
            } else {
                values.problems()
                        .add(
                                o.value(i),
                                place,
                                "the key must be the number of a frame, such as \"0\" or \"25\", not "
                                        + Plain.quoted(o.key(i)));
            }
        }
        Animation.Easing easing = f.word("easing", Animation.Easing.LINEAR);
        return f.make(() -> new Animation.Track(target, keys, easing));
    }

    private static boolean isFrame(String key) {
        return key.matches("0|[1-9][0-9]{0,9}") && Long.parseLong(key) <= Integer.MAX_VALUE;
    }

    private void checkTarget(Fields f, String target) {
        List<String> tokens = JsonPointer.parse(target);
        if (tokens == null) {
            f.problem("target", "must be a JSON pointer such as \"/objects/0/center/1\", not " + Plain.quoted(target));
            return;
        }
        JsonValue found = JsonPointer.resolve(root, tokens);
        if (!(found instanceof JsonValue.Num)) {
            String what = found == null ? "there is nothing" : "there is " + found.describe();
            f.problem("target", "must lead to a number of this file, but at " + Plain.quoted(target) + " " + what);
        } else if (tokens.get(0).equals("animation")) {
            f.problem("target", "must lead to a number outside the animation");
        } else if (!targets.add(tokens)) {
            f.problem("target", Plain.quoted(target) + " is the target of another track too");
        }
    }

    /** Replaces the targets of the tracks by their values at a time. */
    static void apply(Animation animation, Moment time, JsonValue root) {
        for (Animation.Track track : animation.tracks()) {
            List<String> tokens = JsonPointer.parse(track.target());
            String last = tokens.get(tokens.size() - 1);
            JsonValue parent = JsonPointer.resolve(root, tokens.subList(0, tokens.size() - 1));
            JsonValue old = JsonPointer.resolve(root, tokens);
            String text = valueAt(track, time).toString();
            JsonValue number = new JsonValue.Num(old.line, old.column, text);
            if (parent instanceof JsonValue.Obj o) {
                o.replace(last, number);
            } else {
                ((JsonValue.Arr) parent).replace(Integer.parseInt(last), number);
            }
        }
    }

    /** The value of a track at a frame. */
    static BigDecimal valueAt(Animation.Track track, int frame) {
        return valueAt(track, Moment.of(frame));
    }

    /** The value of a track at a time: eased between keys, constant before the first and after the last. */
    static BigDecimal valueAt(Animation.Track track, Moment time) {
        Map.Entry<Integer, BigDecimal> before = track.keys().floorEntry(time.frame());
        Map.Entry<Integer, BigDecimal> after = track.keys().higherEntry(time.frame());
        if (before == null || after == null) {
            return before == null ? after.getValue() : before.getValue();
        }
        BigInteger under = time.under();
        BigInteger late =
                time.over().subtract(BigInteger.valueOf(before.getKey()).multiply(under));
        if (late.signum() == 0) {
            return before.getValue();
        }
        BigInteger length =
                BigInteger.valueOf((long) after.getKey() - before.getKey()).multiply(under);
        if (track.easing() == Animation.Easing.SMOOTH) {
            // s²(3 − 2s) for s = late/length, over length³.
            late = late.multiply(late).multiply(length.multiply(THREE).subtract(late.shiftLeft(1)));
            length = length.pow(3);
        }
        BigDecimal sum = before.getValue()
                .multiply(new BigDecimal(length.subtract(late)))
                .add(after.getValue().multiply(new BigDecimal(late)));
        BigDecimal divisor = new BigDecimal(length);
        return isDecimal(sum, length) ? sum.divide(divisor) : sum.divide(divisor, DECIMALS, RoundingMode.FLOOR);
    }

    /** Whether the quotient is a finite decimal: the reduced divisor has no prime factors but 2 and 5. */
    private static boolean isDecimal(BigDecimal sum, BigInteger length) {
        BigInteger divisor = length.divide(sum.unscaledValue().gcd(length));
        divisor = divisor.shiftRight(divisor.getLowestSetBit());
        while (divisor.mod(FIVE).signum() == 0) {
            divisor = divisor.divide(FIVE);
        }
        return divisor.equals(BigInteger.ONE);
    }
}
