package enlightenment.scene.json.tree;

import enlightenment.scene.SceneException;
import java.util.ArrayList;
import java.util.List;

/**
 * The place of a value in a document: a JSON pointer (RFC 6901) whose text is built on demand.
 */
public final class JsonPointer {
    public static final JsonPointer ROOT = new JsonPointer(null, null, -1);

    private final JsonPointer parent;
    private final String key;
    private final int index;

    private JsonPointer(JsonPointer parent, String key, int index) {
        this.parent = parent;
        this.key = key;
        this.index = index;
    }

    public JsonPointer child(String name) {
        return new JsonPointer(this, name, -1);
    }

    public JsonPointer child(int i) {
        return new JsonPointer(this, null, i);
    }

    /** The place at a relative pointer without leading slash, such as {@code corners/2}; "" is here. */
    public JsonPointer descend(String relativePointer) {
        JsonPointer p = this;
        for (String token : relativePointer.isEmpty() ? new String[0] : relativePointer.split("/", -1)) {
            p = p.child(unescape(token));
        }
        return p;
    }

    /** The JSON pointer; "" for the whole document. */
    @Override
    public String toString() {
        if (parent == null) {
            return "";
        }
        return parent + "/" + (key == null ? Integer.toString(index) : SceneException.escaped(key));
    }

    /** The parts of a JSON pointer, or null if it is not one. */
    public static List<String> parse(String pointer) {
        List<String> tokens = new ArrayList<>();
        if (pointer.isEmpty()) {
            return tokens;
        }
        if (pointer.charAt(0) != '/') {
            return null;
        }
        for (String token : pointer.substring(1).split("/", -1)) {
            if (token.matches("(?s).*~(?![01]).*")) {
                return null;
            }
            tokens.add(unescape(token));
        }
        return tokens;
    }

    private static String unescape(String token) {
        return token.replace("~1", "/").replace("~0", "~");
    }

    /** The value at the pointer's parts, or null. */
    public static JsonValue resolve(JsonValue root, List<String> tokens) {
        JsonValue v = root;
        for (String token : tokens) {
            v = step(v, token);
        }
        return v;
    }

    private static JsonValue step(JsonValue v, String token) {
        if (v instanceof JsonValue.Obj o) {
            return o.get(token);
        }
        if (v instanceof JsonValue.Arr a && token.matches("0|[1-9][0-9]{0,8}")) {
            int i = Integer.parseInt(token);
            return i < a.size() ? a.get(i) : null;
        }
        return null;
    }

    /** The value at the pointer's parts, or the nearest one around it; never null if root is not. */
    public static JsonValue nearest(JsonValue root, List<String> tokens) {
        JsonValue v = root;
        for (String token : tokens) {
            JsonValue next = step(v, token);
            if (next == null) {
                return v;
            }
            v = next;
        }
        return v;
    }
}
