package enlightenment.scene.json;

import enlightenment.color.Color;
import enlightenment.color.Rgb;
import enlightenment.material.Material;
import enlightenment.math.ExactPoint;
import enlightenment.math.InvalidValueException;
import enlightenment.math.Vec3;
import enlightenment.scene.json.tree.JsonPointer;
import enlightenment.scene.json.tree.JsonValue;
import enlightenment.text.Suggestion;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.Supplier;

/**
 * The members of one part of a scene, a JSON object with known keys. Construction reports missing and unknown keys; each getter reports a value of
 * the wrong kind, and then returns a substitute.
 */
final class Fields {
    private final JsonValue.Obj object;
    private final JsonPointer place;
    private final Values values;
    private final int problemsBefore;

    private Fields(JsonValue.Obj object, JsonPointer place, Values values, int problemsBefore) {
        this.object = object;
        this.place = place;
        this.values = values;
        this.problemsBefore = problemsBefore;
    }

    /** The members of a part with the given keys; null after a problem if the value is not an object. */
    static Fields of(JsonValue v, JsonPointer place, Keys keys, Values values) {
        return of(v, place, keys, Map.of(), values);
    }

    /**
     * The members of a part with the given keys; null after a problem if the value is not an object.
     *
     * @param refused other keys that users may expect, with the message for each
     */
    static Fields of(JsonValue v, JsonPointer place, Keys keys, Map<String, String> refused, Values values) {
        int before = values.problems().count();
        JsonValue.Obj o = values.object(v, place, keys.noun());
        if (o == null) {
            return null;
        }
        Fields fields = new Fields(o, place, values, before);
        fields.checkKeys(keys, refused);
        return fields;
    }

    /** The members of a part whose keys depend on its {@code "type"}; null after a problem with the type. */
    static Fields of(JsonValue v, JsonPointer place, Family<?> family, Values values) {
        int before = values.problems().count();
        JsonValue.Obj o = values.object(v, place, family.noun());
        if (o == null) {
            return null;
        }
        JsonValue type = o.get("type");
        String name = family.typeUnlessGiven();
        if (type != null) {
            name = values.word(type, place.child("type"), family.types(), family.plannedTypes());
        } else if (name == null) {
            String message = "missing; expected one of " + Suggestion.list(family.types());
            values.problems().add(o, place.child("type"), message);
        }
        if (name == null) {
            return null;
        }
        Fields fields = new Fields(o, place, values, before);
        fields.checkKeys(family.keys(name), family.refusedKeys(name));
        return fields;
    }

    private void checkKeys(Keys keys, Map<String, String> refused) {
        if (values.areRight(object.keys(), keys)) {
            return;
        }
        int before = values.problems().count();
        for (String required : keys.required()) {
            if (!has(required)) {
                values.problems().add(object, place.child(required), "missing; " + keys.noun() + " needs it");
            }
        }
        for (int i = 0; i < object.size(); i++) {
            String key = object.key(i);
            if (keys.has(key)) {
                continue;
            }
            String message = refused.get(key);
            if (message == null) {
                message = "unknown key" + Suggestion.of(key, keys.all(), keys.noun() + " has");
            }
            values.problems().add(object.value(i), place.child(key), message);
        }
        if (values.problems().count() == before) {
            values.setRight(object.keys(), keys);
        }
    }

    Values values() {
        return values;
    }

    JsonPointer at(String key) {
        return place.child(key);
    }

    JsonValue get(String key) {
        return object.get(key);
    }

    boolean has(String key) {
        return object.get(key) != null;
    }

    /** The type of a part, which is valid or missing. */
    String type(String unlessGiven) {
        return object.get("type") instanceof JsonValue.Str s ? s.text : unlessGiven;
    }

    double number(String key) {
        return number(key, Double.NaN);
    }

    double number(String key, double unlessGiven) {
        JsonValue v = get(key);
        return v == null ? unlessGiven : values.number(v, at(key));
    }

    int integer(String key, int min, int max, int unlessGiven) {
        return (int) whole(key, min, max, unlessGiven);
    }

    long whole(String key, long min, long max, long unlessGiven) {
        JsonValue v = get(key);
        return v == null ? unlessGiven : values.integer(v, at(key), min, max);
    }

    boolean flag(String key, boolean unlessGiven) {
        JsonValue v = get(key);
        return v == null ? unlessGiven : values.flag(v, at(key));
    }

    /** A text; null if it is missing or wrong. */
    String text(String key, String expected) {
        JsonValue v = get(key);
        return v == null ? null : values.text(v, at(key), expected);
    }

    String word(String key, Collection<String> words, String unlessGiven) {
        JsonValue v = get(key);
        return v == null ? unlessGiven : values.word(v, at(key), words, Map.of());
    }

    /** A constant of an enum by its name in lower case; the first one after a problem. */
    <E extends Enum<E>> E word(String key, E unlessGiven) {
        Class<E> type = unlessGiven.getDeclaringClass();
        String word = word(key, words(type), word(unlessGiven));
        return type.getEnumConstants()[Math.max(0, words(type).indexOf(word))];
    }

    /** The words of an enum's constants in scene files. */
    static List<String> words(Class<? extends Enum<?>> type) {
        return Arrays.stream(type.getEnumConstants()).map(Fields::word).toList();
    }

    /** The word of an enum's constant in scene files. */
    static String word(Enum<?> constant) {
        return constant.name().toLowerCase(Locale.ROOT);
    }

    ExactPoint point(String key) {
        JsonValue v = get(key);
        return v == null ? ExactPoint.ORIGIN : values.point(v, at(key));
    }

    Vec3 direction(String key, Vec3 unlessGiven) {
        JsonValue v = get(key);
        return v == null ? unlessGiven : values.vector(v, at(key), "a direction [x, y, z]");
    }

    Vec3 angles(String key, Vec3 unlessGiven) {
        JsonValue v = get(key);
        return v == null ? unlessGiven : values.vector(v, at(key), "three angles [x, y, z] in degrees");
    }

    /** An array of {@code count} positions; origins after a problem. */
    List<ExactPoint> points(String key, int count, String expected) {
        List<ExactPoint> points = new ArrayList<>(count);
        JsonValue v = get(key);
        JsonValue.Arr a = v == null ? null : values.array(v, at(key), count, expected);
        for (int i = 0; i < count; i++) {
            points.add(a == null ? ExactPoint.ORIGIN : values.point(a.get(i), at(key).child(i)));
        }
        return points;
    }

    Color color(String key, Color unlessGiven) {
        JsonValue v = get(key);
        return v == null ? unlessGiven : values.color(v, at(key));
    }

    /** A number for each colour band, or one for all. */
    Rgb bands(String key, Rgb unlessGiven) {
        JsonValue v = get(key);
        return v == null ? unlessGiven : values.bands(v, at(key));
    }

    /** A band of wavelengths; null if it is missing or wrong. */
    Material.WavelengthBand wavelengths(String key) {
        JsonValue v = get(key);
        return v == null ? null : values.wavelengths(v, at(key));
    }

    /** Reports a problem at a key of this part. */
    void problem(String key, String message) {
        JsonValue v = get(key);
        values.problems().add(v == null ? object : v, at(key), message);
    }

    /**
     * Makes a record from valid values. An exception of the record is reported at the place of its key.
     *
     * @return null after a problem of this part
     */
    <T> T make(Supplier<T> maker) {
        if (values.problems().count() > problemsBefore) {
            return null;
        }
        try {
            return maker.get();
        } catch (InvalidValueException e) {
            String key = e.key();
            List<String> tokens = key.isEmpty() ? List.of() : JsonPointer.parse("/" + key);
            values.problems().add(JsonPointer.nearest(object, tokens), place.descend(key), e.problem());
            return null;
        }
    }
}
