package enlightenment.scene.json;

import enlightenment.scene.json.tree.JsonPointer;
import enlightenment.scene.json.tree.JsonValue;
import enlightenment.text.Plain;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.stream.Collectors;

/** Groups: objects that the scene has a name for, which stand wherever an object of type group places them. */
final class Groups {
    static final String TYPE = "group";
    static final Keys OBJECT = Keys.of("groupObject", "a group", "type group", "transform name");

    /** The limit of groups in groups. */
    static final int DEEPEST = 16;

    /** The limit of what groups place, those in groups counted at each: a short file could ask for any number. */
    static final long MOST_PLACED = 5_000_000;

    static final String TOO_MUCH = "places too much: groups place at most " + MOST_PLACED + " objects";

    private Groups() {}

    /** How many objects a group places, or more than {@link #MOST_PLACED}; 0 of a group that there is not. */
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

    /** Notes the groups of a scene in the library; they are read when an object places one. */
    static void note(JsonValue v, JsonPointer place, Values values) {
        JsonValue.Obj o = values.object(v, place, "groups by their names, each an array of objects");
        for (int i = 0; o != null && i < o.size(); i++) {
            values.library().unreadGroups.put(o.key(i), o.value(i));
        }
    }

    /**
     * The problem of a group that lies in itself.
     *
     * @param within the groups that it is placed in, the outermost first
     */
    static String circle(String name, List<String> within) {
        List<String> chain = new ArrayList<>(within.subList(within.indexOf(name), within.size()));
        chain.add(name);
        Collections.reverse(chain);
        return "the group " + Plain.quoted(name) + " lies in itself: "
                + chain.stream().map(Plain::quoted).collect(Collectors.joining(" in "));
    }
}
