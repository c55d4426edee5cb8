package enlightenment.scene.json;

import enlightenment.color.Color;
import enlightenment.color.DisplayRgb;
import enlightenment.color.Rgb;
import enlightenment.material.Material;
import enlightenment.math.ExactPoint;
import enlightenment.math.InvalidValueException;
import enlightenment.math.Vec3;
import enlightenment.scene.json.tree.JsonPointer;
import enlightenment.scene.json.tree.JsonValue;
import enlightenment.scene.json.tree.Numbers;
import enlightenment.scene.json.tree.Problems;
import enlightenment.text.Plain;
import enlightenment.text.Suggestion;
import java.math.BigDecimal;
import java.math.BigInteger;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Supplier;

/**
 * Conversions of JSON values. A value of the wrong kind is reported with what was found and what was expected; a substitute is then returned, so that
 * further problems can be found.
 */
final class Values {
    /** The accepted colour words, for messages. */
    static final String COLOR = "a colour: \"#rrggbb\", \"#rgb\", a CSS colour name such as \"teal\"";

    /** The accepted form of linear colours, for messages. */
    static final String LINEAR = "{\"linear\": [r, g, b]} with components of at least 0";

    private final Problems problems;
    private final Library library;
    private String[] rightKeys;
    private Keys rightFor;

    Values(Problems problems, Library library) {
        this.problems = problems;
        this.library = library;
    }

    /** The named parts of the scene. */
    Library library() {
        return library;
    }

    Problems problems() {
        return problems;
    }

    /** Whether the last valid part had the same array of keys and was of the same kind. */
    boolean areRight(String[] written, Keys keys) {
        return written == rightKeys && keys == rightFor;
    }

    /** Caches the keys of a valid part, since the next part mostly has the same ones. */
    void setRight(String[] written, Keys keys) {
        rightKeys = written;
        rightFor = keys;
    }

    /** A finite double, correctly rounded from the decimal; NaN after a problem. */
    double number(JsonValue v, JsonPointer place) {
        return isNumber(v, place, "a number") ? Double.parseDouble(((JsonValue.Num) v).text) : Double.NaN;
    }

    /** The exact value of a number within the range of doubles; zero after a problem. */
    BigDecimal exact(JsonValue v, JsonPointer place) {
        return isNumber(v, place, "a number") ? Numbers.exact(((JsonValue.Num) v).text) : BigDecimal.ZERO;
    }

    /** The text of a coordinate within the range of doubles; "0" after a problem. */
    private String decimal(JsonValue v, JsonPointer place, int axis) {
        return isNumber(v, place.child(axis), "a number") ? Numbers.decimal(((JsonValue.Num) v).text) : "0";
    }

    private boolean isNumber(JsonValue v, JsonPointer place, String expected) {
        if (!(v instanceof JsonValue.Num n)) {
            problems.add(v, place, "must be " + expected + ", not " + v.describe());
            return false;
        }
        String objection = Numbers.objection(n.text);
        if (objection != null) {
            problems.add(v, place, objection);
        }
        return objection == null;
    }

    /** A whole number between two limits; the lower limit after a problem. */
    long integer(JsonValue v, JsonPointer place, long min, long max) {
        String expected = "a whole number in " + min + ".." + max;
        if (!isNumber(v, place, expected)) {
            return min;
        }
        BigDecimal exact = Numbers.exact(((JsonValue.Num) v).text);
        boolean whole = exact.signum() == 0 || exact.stripTrailingZeros().scale() <= 0;
        if (whole && exact.precision() - exact.scale() <= 20) {
            BigInteger i = exact.toBigIntegerExact();
            if (i.compareTo(BigInteger.valueOf(min)) >= 0 && i.compareTo(BigInteger.valueOf(max)) <= 0) {
                return i.longValueExact();
            }
        }
        problems.add(v, place, "must be " + expected + ", not " + Plain.excerpt(((JsonValue.Num) v).text));
        return min;
    }

    /** true or false; false after a problem. */
    boolean flag(JsonValue v, JsonPointer place) {
        if (v instanceof JsonValue.Bool b) {
            return b.value;
        }
        problems.add(v, place, "must be true or false, not " + v.describe());
        return false;
    }

    /** A text; null after a problem. */
    String text(JsonValue v, JsonPointer place, String expected) {
        if (v instanceof JsonValue.Str s) {
            return s.text;
        }
        problems.add(v, place, "must be " + expected + ", not " + v.describe());
        return null;
    }

    /**
     * One of the given words; null after a problem.
     *
     * @param planned words that the format will have, with the reason why each is missing, or ""
     */
    String word(JsonValue v, JsonPointer place, Collection<String> words, Map<String, String> planned) {
        if (!(v instanceof JsonValue.Str s)) {
            problems.add(v, place, "must be one of " + Suggestion.list(words) + ", not " + v.describe());
            return null;
        }
        String text = s.text;
        if (words.contains(text)) {
            return text;
        }
        String missing = planned.get(text);
        if (missing != null) {
            String reason = missing.isEmpty() ? "" : ": " + missing;
            problems.add(
                    v,
                    place,
                    "\"" + text + "\" is not available yet" + reason + "; expected one of " + Suggestion.list(words));
        } else {
            problems.add(v, place, "unknown: " + Plain.quoted(text) + Suggestion.of(text, words, "expected one of"));
        }
        return null;
    }

    /** An array of the given length, any length if that is negative; null after a problem. */
    JsonValue.Arr array(JsonValue v, JsonPointer place, int length, String expected) {
        if (v instanceof JsonValue.Arr a && (length < 0 || a.size() == length)) {
            return a;
        }
        problems.add(v, place, "must be " + expected + ", not " + v.describe());
        return null;
    }

    /** A JSON object that is a part of a scene; null after a problem. */
    JsonValue.Obj object(JsonValue v, JsonPointer place, String noun) {
        if (v instanceof JsonValue.Obj o) {
            return o;
        }
        problems.add(v, place, "must be " + noun + ", an object { ... }, not " + v.describe());
        return null;
    }

    /** An exact position; the origin after a problem. */
    ExactPoint point(JsonValue v, JsonPointer place) {
        JsonValue.Arr a = array(v, place, 3, "a position [x, y, z]");
        if (a == null) {
            return ExactPoint.ORIGIN;
        }
        return ExactPoint.of(decimal(a.get(0), place, 0), decimal(a.get(1), place, 1), decimal(a.get(2), place, 2));
    }

    /** Three doubles; zeros after a problem. */
    Vec3 vector(JsonValue v, JsonPointer place, String expected) {
        JsonValue.Arr a = array(v, place, 3, expected);
        if (a == null) {
            return Vec3.ZERO;
        }
        return new Vec3(
                number(a.get(0), place.child(0)), number(a.get(1), place.child(1)), number(a.get(2), place.child(2)));
    }

    /**
     * A colour without texture; black after a problem. It is a word ({@link #named}), {@code [r, g, b]} or {@code {"linear": [r, g, b]}}.
     */
    Color color(JsonValue v, JsonPointer place) {
        return color(v, place, COLOR + ", [r, g, b] with components in 0..1, or " + LINEAR);
    }

    /** {@link #color(JsonValue, JsonPointer)} with another message, for places where more than a colour is allowed. */
    Color color(JsonValue v, JsonPointer place, String expected) {
        if (v instanceof JsonValue.Obj o && o.get("texture") == null) {
            if (o.get("linear") != null) {
                return linear(v, place);
            }
            problems.add(v, place, "must be " + expected + ", not " + describe(o, List.of("linear")));
            return DisplayRgb.BLACK;
        }
        if (v instanceof JsonValue.Str s) {
            Optional<DisplayRgb> named = named(s.text);
            if (named.isEmpty()) {
                String meant = Suggestion.nearest(s.text, ColorNames.ALL.keySet());
                String suggestion = meant == null ? "" : "; did you mean \"" + meant + "\"?";
                problems.add(v, place, "must be " + expected + ", not " + v.describe() + suggestion);
                return DisplayRgb.BLACK;
            }
            return named.get();
        }
        JsonValue.Arr a = array(v, place, 3, expected);
        if (a == null) {
            return DisplayRgb.BLACK;
        }
        return new DisplayRgb(component(a, 0, place), component(a, 1, place), component(a, 2, place));
    }

    /**
     * A description of an object of no accepted kind, for messages: by its first key, which may be misspelt.
     *
     * @param kinds keys that distinguish the accepted kinds
     */
    static String describe(JsonValue.Obj o, List<String> kinds) {
        if (o.size() == 0) {
            return "an empty object";
        }
        String meant = Suggestion.nearest(o.key(0), kinds);
        return "an object with " + Plain.quoted(o.key(0)) + (meant == null ? "" : "; did you mean \"" + meant + "\"?");
    }

    private Rgb linear(JsonValue v, JsonPointer place) {
        Fields f = Fields.of(v, place, PartKeys.LINEAR_COLOR, this);
        return f.has("linear") ? three(f.get("linear"), f.at("linear"), "three numbers [r, g, b]") : Rgb.BLACK;
    }

    /** A number of at least 0 for each colour band, or one for all; black after a problem. */
    Rgb bands(JsonValue v, JsonPointer place) {
        return v instanceof JsonValue.Num
                ? Rgb.gray(notNegative(v, place))
                : three(v, place, "a number, or [r, g, b] with components of at least 0");
    }

    /** Two wavelengths; null after a problem. */
    Material.WavelengthBand wavelengths(JsonValue v, JsonPointer place) {
        int before = problems.count();
        JsonValue.Arr a = array(v, place, 2, "two wavelengths [from, to] in nanometres");
        double low = a == null ? Double.NaN : number(a.get(0), place.child(0));
        double high = a == null ? Double.NaN : number(a.get(1), place.child(1));
        if (problems.count() > before) {
            return null;
        }
        return make(v, place, () -> new Material.WavelengthBand(low, high));
    }

    /** Makes a record from a value. An exception of the record is reported at the value, and the result is null. */
    <T> T make(JsonValue v, JsonPointer place, Supplier<T> maker) {
        try {
            return maker.get();
        } catch (InvalidValueException e) {
            problems.add(v, place, e.problem());
            return null;
        }
    }

    private Rgb three(JsonValue v, JsonPointer place, String expected) {
        JsonValue.Arr a = array(v, place, 3, expected);
        if (a == null) {
            return Rgb.BLACK;
        }
        return new Rgb(
                notNegative(a.get(0), place.child(0)),
                notNegative(a.get(1), place.child(1)),
                notNegative(a.get(2), place.child(2)));
    }

    private double notNegative(JsonValue v, JsonPointer place) {
        double d = number(v, place);
        if (d < 0) {
            problems.add(v, place, "must be a number of at least 0, not " + d);
        }
        return d >= 0 ? d : 0;
    }

    /** The colour of {@code "#rrggbb"}, {@code "#rgb"} or a colour's name; empty for anything else. */
    private static Optional<DisplayRgb> named(String text) {
        Integer bits = ColorNames.ALL.get(text);
        return bits == null ? DisplayRgb.ofHexadecimal(text) : Optional.of(DisplayRgb.ofBits(bits));
    }

    private double component(JsonValue.Arr a, int i, JsonPointer place) {
        double c = number(a.get(i), place.child(i));
        if (c < 0 || c > 1) {
            problems.add(a.get(i), place.child(i), "must be a colour component in 0..1, not " + c);
        }
        return c >= 0 && c <= 1 ? c : 0;
    }
}
