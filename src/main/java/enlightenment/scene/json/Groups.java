package enlightenment.scene.json;

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

    private Groups() {}

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
