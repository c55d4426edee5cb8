package enlightenment.scene.json;

import java.util.Iterator;
import java.util.List;
import java.util.Map;

/**
 * Prints JSON for people: what fits in a line stands in a line, the rest is broken and indented. A value is a map, a
 * list, or a string that is JSON already.
 */
final class JsonText {
    private static final int WIDTH = 110;
    private static final String INDENT = "  ";

    private JsonText() {}

    /** The document with a line break at its end. */
    static String print(Map<String, Object> document) {
        StringBuilder s = new StringBuilder();
        broken(s, document, 0);
        return s.append('\n').toString();
    }

    private static void value(StringBuilder s, Object value, int depth) {
        int start = s.length();
        int room = Math.max(40, WIDTH - INDENT.length() * depth);
        if (!inline(s, value, start + room)) {
            s.setLength(start);
            broken(s, value, depth);
        }
    }

    /** Prints in one line; false where that would end beyond the limit. */
    private static boolean inline(StringBuilder s, Object value, int limit) {
        if (value instanceof Map) {
            Map<?, ?> map = (Map<?, ?>) value;
            String between = "{ ";
            for (Map.Entry<?, ?> e : map.entrySet()) {
                s.append(between).append(quote((String) e.getKey())).append(": ");
                if (!inline(s, e.getValue(), limit)) {
                    return false;
                }
                between = ", ";
            }
            s.append(map.isEmpty() ? "{}" : " }");
        } else if (value instanceof List) {
            String between = "[";
            for (Object e : (List<?>) value) {
                s.append(between);
                if (!inline(s, e, limit)) {
                    return false;
                }
                between = ", ";
            }
            s.append(((List<?>) value).isEmpty() ? "[]" : "]");
        } else {
            s.append((String) value);
        }
        return s.length() <= limit;
    }

    private static void broken(StringBuilder s, Object value, int depth) {
        if (value instanceof Map) {
            s.append('{');
            Iterator<? extends Map.Entry<?, ?>> i =
                    ((Map<?, ?>) value).entrySet().iterator();
            while (i.hasNext()) {
                Map.Entry<?, ?> e = i.next();
                line(s, depth + 1);
                s.append(quote((String) e.getKey())).append(": ");
                value(s, e.getValue(), depth + 1);
                s.append(i.hasNext() ? "," : "");
            }
            line(s, depth);
            s.append('}');
        } else if (value instanceof List) {
            s.append('[');
            Iterator<?> i = ((List<?>) value).iterator();
            while (i.hasNext()) {
                line(s, depth + 1);
                value(s, i.next(), depth + 1);
                s.append(i.hasNext() ? "," : "");
            }
            line(s, depth);
            s.append(']');
        } else {
            s.append((String) value);
        }
    }

    private static void line(StringBuilder s, int depth) {
        s.append('\n').append(INDENT.repeat(depth));
    }

    /** Text as a JSON string. */
    static String quote(String text) {
        StringBuilder s = new StringBuilder(text.length() + 2).append('"');
        for (int i = 0; i < text.length(); i++) {
            char c = text.charAt(i);
            if (c == '"' || c == '\\') {
                s.append('\\').append(c);
            } else if (c < ' ' || isLoneSurrogate(text, i)) {
                s.append("\\u");
                for (int shift = 12; shift >= 0; shift -= 4) {
                    s.append(Character.forDigit(c >> shift & 15, 16));
                }
            } else {
                s.append(c);
            }
        }
        return s.append('"').toString();
    }

    /** Half a character has no form in UTF-8, so it must be written as an escape. */
    private static boolean isLoneSurrogate(String text, int i) {
        char c = text.charAt(i);
        if (Character.isHighSurrogate(c)) {
            return i + 1 == text.length() || !Character.isLowSurrogate(text.charAt(i + 1));
        }
        return Character.isLowSurrogate(c) && (i == 0 || !Character.isHighSurrogate(text.charAt(i - 1)));
    }
}
