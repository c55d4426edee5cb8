package enlightenment.scene.json;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** A value of a JSON document, with its place in the file. */
abstract class Node {
    private static final int SHOWN = 60;

    /** What holds this value, or null for the whole document. */
    final Node parent;
    /** Which of the parent's values this is. */
    final int index;

    final int line;
    final int column;

    Node(Node parent, int index, int line, int column) {
        this.parent = parent;
        this.index = index;
        this.line = line;
        this.column = column;
    }

    /** The value in words, for "expected this, found that". */
    abstract String describe();

    /** The value with this key or index, or null. */
    Node child(String segment) {
        return null;
    }

    /** The JSON pointer to this value. */
    final String pointer() {
        return parent == null ? "" : parent.pointer() + "/" + escape(parent.segment(index));
    }

    String segment(int i) {
        return Integer.toString(i);
    }

    static String escape(String segment) {
        return segment.replace("~", "~0").replace("/", "~1");
    }

    /** Text in quotes, shortened where it is long. */
    static String quote(String text) {
        int n = text.length();
        return n <= SHOWN ? "\"" + text + "\"" : "\"" + text.substring(0, SHOWN) + "…\" (" + n + " characters)";
    }

    /** An object: keys in the order of the file, each once. */
    static final class Obj extends Node {
        private static final int FEW = 12;
        private final List<String> keys = new ArrayList<>(6);
        private final List<Node> values = new ArrayList<>(6);
        private long[] keyPlaces = new long[6];
        private Map<String, Integer> lookup;

        Obj(Node parent, int index, int line, int column) {
            super(parent, index, line, column);
        }

        int size() {
            return values.size();
        }

        String key(int i) {
            return keys.get(i);
        }

        String keyOrNull(int i) {
            return i < keys.size() ? keys.get(i) : null;
        }

        Node value(int i) {
            return values.get(i);
        }

        int keyLine(int i) {
            return (int) (keyPlaces[i] >>> 32);
        }

        int keyColumn(int i) {
            return (int) keyPlaces[i];
        }

        List<String> keys() {
            return keys;
        }

        Node get(String key) {
            int i = indexOf(key);
            return i < 0 ? null : values.get(i);
        }

        int indexOf(String key) {
            if (lookup != null) {
                Integer found = lookup.get(key);
                return found == null ? -1 : found;
            }
            return keys.indexOf(key);
        }

        /** Adds a key whose value follows by {@link #addValue}. */
        void addKey(String key, int keyLine, int keyColumn) {
            int n = keys.size();
            if (n == keyPlaces.length) {
                keyPlaces = java.util.Arrays.copyOf(keyPlaces, 2 * n);
            }
            keyPlaces[n] = (long) keyLine << 32 | keyColumn;
            keys.add(key);
            if (lookup != null) {
                lookup.put(key, n);
            } else if (n == FEW) {
                lookup = new HashMap<>();
                for (int i = 0; i <= n; i++) {
                    lookup.put(keys.get(i), i);
                }
            }
        }

        void addValue(Node value) {
            values.add(value);
        }

        @Override
        Node child(String segment) {
            return get(segment);
        }

        @Override
        String segment(int i) {
            return keys.get(i);
        }

        @Override
        String describe() {
            return "an object";
        }
    }

    /** An array. */
    static final class Arr extends Node {
        final List<Node> values = new ArrayList<>(4);

        Arr(Node parent, int index, int line, int column) {
            super(parent, index, line, column);
        }

        @Override
        Node child(String segment) {
            int n = segment.length();
            if (n == 0 || n > 9 || n > 1 && segment.charAt(0) == '0') {
                return null;
            }
            int value = 0;
            for (int i = 0; i < n; i++) {
                int digit = segment.charAt(i) - '0';
                if (digit < 0 || digit > 9) {
                    return null;
                }
                value = 10 * value + digit;
            }
            return value < values.size() ? values.get(value) : null;
        }

        @Override
        String describe() {
            return values.isEmpty() ? "an empty array" : "an array of " + values.size();
        }
    }

    /** A number: the text of the file, or of the frame where an animation replaced it. */
    static final class Num extends Node {
        String text;
        /** Whether an animation replaced the number that the file gives. */
        boolean animated;
        /** Whether it was refused, and said so, already. */
        boolean bad;

        Num(Node parent, int index, int line, int column, String text) {
            super(parent, index, line, column);
            this.text = text;
        }

        @Override
        String describe() {
            return "the number " + Numbers.shortened(text);
        }
    }

    /** A string. */
    static final class Str extends Node {
        final String text;

        Str(Node parent, int index, int line, int column, String text) {
            super(parent, index, line, column);
            this.text = text;
        }

        @Override
        String describe() {
            return "the string " + quote(text);
        }
    }

    /** True, false or null. */
    static final class Word extends Node {
        /** Null for null. */
        final Boolean value;

        Word(Node parent, int index, int line, int column, Boolean value) {
            super(parent, index, line, column);
            this.value = value;
        }

        @Override
        String describe() {
            return value == null ? "null" : value.toString();
        }
    }
}
