package enlightenment.scene.json;

import enlightenment.scene.json.tree.JsonPointer;
import enlightenment.scene.json.tree.JsonValue;
import enlightenment.text.Plain;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.stream.Collectors;

/** Groups: named lists of objects, which objects of type group place any number of times. */
final class Groups {
    static final String TYPE = "group";
    static final Keys OBJECT = Keys.of("groupObject", "a group", "type group", "transform name");

    /** The greatest nesting depth of groups. */
    static final int DEEPEST = 16;

    /** The most objects placed by groups, counted for each placement: a short file could place any number. */
    static final long MOST_PLACED = 5_000_000;

    static final String TOO_MUCH = "places too much: groups place at most " + MOST_PLACED + " objects";

    private Groups() {}

    /** Number of objects that a group places, inexact above {@link #MOST_PLACED}; 0 for an unknown group. */
    static long count(Library library, String name, int depth) {
        Long known = library.groupCounts.get(name);
        if (known != null || depth > DEEPEST) {
            return known == null ? 0 : known;
        }
        long count = 0;
        if (library.unreadGroups.get(name) instanceof JsonValue.Arr a) {
            for (int i = 0; i < a.size() && count <= MOST_PLACED; i++) {
                boolean isGroup = a.get(i) instanceof JsonValue.Obj o
                        && o.get("group") instanceof JsonValue.Str
                        && o.get("type") instanceof JsonValue.Str type
                        && type.text.equals(TYPE);
                count += isGroup
                        ? count(library, ((JsonValue.Str) ((JsonValue.Obj) a.get(i)).get("group")).text, depth + 1)
                        : 1;
            }
        }
        library.groupCounts.put(name, count);
        return count;
    }

    /** Adds the JSON of groups to the library; a group is read when an object places it. */
    static void note(JsonValue v, JsonPointer place, Values values) {
        JsonValue.Obj o = values.object(v, place, "groups by their names, each an array of objects");
        for (int i = 0; o != null && i < o.size(); i++) {
            values.library().unreadGroups.put(o.key(i), o.value(i));
        }
    }

    /**
     * The message for a group that contains itself.
     *
     * @param within names of the enclosing groups, the outermost first
     */
    static String circle(String name, List<String> within) {
        List<String> chain = new ArrayList<>(within.subList(within.indexOf(name), within.size()));
        chain.add(name);
        Collections.reverse(chain);
        return "the group " + Plain.quoted(name) + " lies in itself: "
                + chain.stream().map(Plain::quoted).collect(Collectors.joining(" in "));
    }
}
