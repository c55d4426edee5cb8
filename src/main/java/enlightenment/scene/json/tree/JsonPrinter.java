package enlightenment.scene.json.tree;

import java.util.Locale;

/**
 * Printer of readable JSON. Values that fit are on one line, but each part of a scene, and each item of its lists, starts a line of its own.
 */
public final class JsonPrinter {
    private static final int LINE_WIDTH = 120;
    private static final int INDENT = 2;

    /** Lists of objects are broken down to this depth even where they would fit on one line. */
    private static final int BROKEN_DEPTH = 2;

    private final StringBuilder out = new StringBuilder();

    private JsonPrinter() {}

    public static String print(JsonValue v) {
        JsonPrinter printer = new JsonPrinter();
        printer.value(v, 0, 0);
        return printer.out.append('\n').toString();
    }

    private void value(JsonValue v, int depth, int used) {
        int left = LINE_WIDTH - depth * INDENT - used;
        boolean list = depth < BROKEN_DEPTH && holdsObjects(v);
        if (isEmpty(v) || !list && width(v, left) <= left) {
            line(v);
        } else if (v instanceof JsonValue.Obj o) {
            out.append('{');
            for (int i = 0; i < o.size(); i++) {
                newLine(i, depth + 1);
                int start = out.length();
                text(o.key(i));
                out.append(": ");
                value(o.value(i), depth + 1, out.length() - start + 1);
            }
            newLine(0, depth);
            out.append('}');
        } else if (v instanceof JsonValue.Arr a) {
            out.append('[');
            for (int i = 0; i < a.size(); i++) {
                newLine(i, depth + 1);
                value(a.get(i), depth + 1, 1);
            }
            newLine(0, depth);
            out.append(']');
        } else {
            line(v);
        }
    }

    private void newLine(int comma, int depth) {
        out.append(comma > 0 ? ",\n" : "\n").append(" ".repeat(depth * INDENT));
    }

    private static boolean isEmpty(JsonValue v) {
        return v instanceof JsonValue.Obj o && o.size() == 0 || v instanceof JsonValue.Arr a && a.size() == 0;
    }

    private static boolean holdsObjects(JsonValue v) {
        if (v instanceof JsonValue.Obj o) {
            return o.size() > 0 && o.value(0) instanceof JsonValue.Obj;
        }
        return v instanceof JsonValue.Arr a && a.size() > 0 && a.get(0) instanceof JsonValue.Obj;
    }

    /** The width on one line, in characters; any number above the limit if that is exceeded. */
    private static int width(JsonValue v, int limit) {
        int w = 4;
        if (v instanceof JsonValue.Obj o) {
            for (int i = 0; i < o.size() && w <= limit; i++) {
                w += o.key(i).length() + 6 + width(o.value(i), limit - w);
            }
        } else if (v instanceof JsonValue.Arr a) {
            for (int i = 0; i < a.size() && w <= limit; i++) {
                w += 2 + width(a.get(i), limit - w);
            }
        } else if (v instanceof JsonValue.Str s) {
            w = s.text.length() + 2;
        } else if (v instanceof JsonValue.Num n) {
            w = n.text.length();
        }
        return w;
    }

    private void line(JsonValue v) {
        if (v instanceof JsonValue.Obj o) {
            out.append(o.size() == 0 ? "{" : "{ ");
            for (int i = 0; i < o.size(); i++) {
                out.append(i > 0 ? ", " : "");
                text(o.key(i));
                out.append(": ");
                line(o.value(i));
            }
            out.append(o.size() == 0 ? "}" : " }");
        } else if (v instanceof JsonValue.Arr a) {
            out.append('[');
            for (int i = 0; i < a.size(); i++) {
                out.append(i > 0 ? ", " : "");
                line(a.get(i));
            }
            out.append(']');
        } else if (v instanceof JsonValue.Str s) {
            text(s.text);
        } else if (v instanceof JsonValue.Num n) {
            out.append(n.text);
        } else if (v instanceof JsonValue.Bool b) {
            out.append(b.value);
        } else {
            out.append("null");
        }
    }

    private void text(String s) {
        out.append('"');
        for (int i = 0; i < s.length(); i++) {
            char c = s.charAt(i);
            if (c == '"' || c == '\\') {
                out.append('\\').append(c);
            } else if (c == '\n') {
                out.append("\\n");
            } else if (c == '\t') {
                out.append("\\t");
            } else if (Character.isISOControl(c) || c == '\ufeff') {
                out.append(String.format(Locale.ROOT, "\\u%04x", (int) c));
            } else {
                out.append(c);
            }
        }
        out.append('"');
    }
}
