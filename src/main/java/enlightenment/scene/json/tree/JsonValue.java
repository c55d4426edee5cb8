package enlightenment.scene.json.tree;

import enlightenment.text.Plain;
import java.util.List;

/**
 * A parsed JSON value with its line and column. Compact, as a scene may have millions of values.
 *
 * <p>Numbers keep their text, which is parsed later, exactly or as a double.
 */
public abstract sealed class JsonValue {
    /** Line of the value's first character, counted from 1; 0 where the value comes from no file. */
    public final int line;

    /** Column of the value's first character, counted from 1. */
    public final int column;

    private JsonValue(int line, int column) {
        this.line = line;
        this.column = column;
    }

    /** A description of the value for messages: {@code the text "abc"}. */
    public abstract String describe();

    /** An object; the keys keep their order, and of a duplicate key the last value counts. */
    public static final class Obj extends JsonValue {
        private final String[] keys;
        private final JsonValue[] values;

        public Obj(int line, int column, String[] keys, JsonValue[] values) {
            super(line, column);
            this.keys = keys;
            this.values = values;
        }

        public int size() {
            return keys.length;
        }

        public String key(int i) {
            return keys[i];
        }

        public JsonValue value(int i) {
            return values[i];
        }

        /** The keys, shared: not to be changed. */
        public String[] keys() {
            return keys;
        }

        /** The value of a key, or null. */
        public JsonValue get(String key) {
            int i = indexOf(key);
            return i < 0 ? null : values[i];
        }

        private int indexOf(String key) {
            for (int i = keys.length - 1; i >= 0; i--) {
                if (keys[i].equals(key)) {
                    return i;
                }
            }
            return -1;
        }

        /** Replaces the value of an existing key; used only to apply animation, before the scene is bound. */
        public void replace(String key, JsonValue value) {
            values[indexOf(key)] = value;
        }

        @Override
        public String describe() {
            return "an object";
        }
    }

    /** An array. */
    public static final class Arr extends JsonValue {
        private final JsonValue[] items;

        public Arr(int line, int column, JsonValue[] items) {
            super(line, column);
            this.items = items;
        }

        public static Arr of(List<JsonValue> items) {
            return new Arr(0, 0, items.toArray(JsonValue[]::new));
        }

        public int size() {
            return items.length;
        }

        public JsonValue get(int i) {
            return items[i];
        }

        public void replace(int i, JsonValue value) {
            items[i] = value;
        }

        @Override
        public String describe() {
            return items.length == 1 ? "an array of 1 value" : "an array of " + items.length + " values";
        }
    }

    /** A number as it was written, also NaN and the infinities, which are refused later with their place. */
    public static final class Num extends JsonValue {
        public final String text;

        public Num(int line, int column, String text) {
            super(line, column);
            this.text = text;
        }

        @Override
        public String describe() {
            return "the number " + Plain.excerpt(text);
        }
    }

    /** A text. */
    public static final class Str extends JsonValue {
        public final String text;

        public Str(int line, int column, String text) {
            super(line, column);
            this.text = text;
        }

        @Override
        public String describe() {
            return "the text " + Plain.quoted(text);
        }
    }

    /** true or false. */
    public static final class Bool extends JsonValue {
        public final boolean value;

        public Bool(int line, int column, boolean value) {
            super(line, column);
            this.value = value;
        }

        @Override
        public String describe() {
            return Boolean.toString(value);
        }
    }

    /** null, which no part of a scene may be. */
    public static final class Null extends JsonValue {
        public Null(int line, int column) {
            super(line, column);
        }

        @Override
        public String describe() {
            return "null";
        }
    }
}
