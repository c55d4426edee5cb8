package enlightenment.scene.json;

import enlightenment.text.Plain;
import java.util.List;
import java.util.stream.Collectors;

/** Groups: objects that the scene has a name for, which stand wherever an object of type group places them. */
final class Groups {
    static final String TYPE = "group";
    static final Keys OBJECT = Keys.of("groupObject", "a group", "type group", "transform name");

    /** Groups lie in groups at most so deep. */
    static final int DEEPEST = 16;

    private Groups() {}

    /** Notes the groups of a scene in the library; they are read when an object places one. */
    static void note(JsonValue v, JsonPointer place, Values values) {
        JsonValue.Obj o = values.object(v, place, "groups by their names, each an array of objects");
        for (int i = 0; o != null && i < o.size(); i++) {
            values.library().unreadGroups.put(o.key(i), o.value(i));
        }
    }

    /** What is wrong with a group that lies in these. */
    static String objection(String name, List<String> within) {
        String chain = within.stream().map(Plain::quoted).collect(Collectors.joining(" in "));
        return within.contains(name)
                ? "the group " + Plain.quoted(name) + " lies in itself, by way of " + chain
                : "groups lie in each other more than " + DEEPEST + " deep";
    }
}
