package enlightenment.scene.json;

import enlightenment.camera.Camera;
import enlightenment.scene.Scene;
import enlightenment.scene.json.tree.JsonPointer;
import enlightenment.scene.json.tree.JsonPrinter;
import enlightenment.scene.json.tree.JsonValue;
import enlightenment.scene.json.tree.MemberSpans;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * Changes single values in the text of a scene file. All other characters stay as they are: comments, order, layout, spelling of numbers.
 */
final class SceneEdit {
    private SceneEdit() {}

    /**
     * The JSON object of a camera in a scene file, without a line end behind it.
     *
     * @throws enlightenment.scene.SceneException if the format cannot represent one of its numbers, such as a coordinate of 1e-500
     */
    static String json(Camera camera) {
        return JsonPrinter.print(object(camera)).strip();
    }

    /**
     * Replaces the values that differ between two cameras.
     *
     * @param text a scene file that {@link SceneReader} reads; a byte order mark may stand first
     * @param before the camera of that file
     * @param after the camera to be written, of the kind of {@code before}
     * @return the new text; {@code text} itself if the cameras are equal
     * @throws IllegalArgumentException if the cameras are of different kinds, or the text is no JSON object with a camera
     */
    static String withCamera(String text, Camera before, Camera after) {
        if (!before.type().equals(after.type())) {
            throw new IllegalArgumentException(
                    "a " + before.type() + " camera cannot become a " + after.type() + " camera");
        }
        return with(text, "camera", changes(object(before), object(after)));
    }

    /**
     * Sets the exposure of the part {@code display}, which is added if there is none.
     *
     * @param text a scene file that {@link SceneReader} reads
     * @param exposure in stops, −{@link Scene.Display#MAX_EXPOSURE}..{@link Scene.Display#MAX_EXPOSURE}
     * @return the new text
     * @throws IllegalArgumentException if the text is no JSON object
     */
    static String withExposure(String text, double exposure) {
        return with(text, "display", Map.of("exposure", number(exposure)));
    }

    private static String number(double v) {
        JsonValue.Obj o = (JsonValue.Obj)
                new JsonObjectBuilder(JsonPointer.ROOT, null).number("n", v).json();
        return JsonPrinter.print(o.value(0)).strip();
    }

    private static JsonValue.Obj object(Camera camera) {
        JsonObjectBuilder p = new JsonObjectBuilder(JsonPointer.ROOT.child("camera"), null);
        Cameras.FAMILY.write(camera, p);
        return (JsonValue.Obj) p.json();
    }

    /** The values that are new or differ, by key. */
    private static Map<String, String> changes(JsonValue.Obj before, JsonValue.Obj after) {
        Map<String, String> changes = new LinkedHashMap<>();
        for (int i = 0; i < after.size(); i++) {
            JsonValue old = before.get(after.key(i));
            String value = JsonPrinter.print(after.value(i)).strip();
            if (old == null || !JsonPrinter.print(old).strip().equals(value)) {
                changes.put(after.key(i), value);
            }
        }
        return changes;
    }

    private static String with(String text, String part, Map<String, String> values) {
        String edited = text;
        for (Map.Entry<String, String> value : values.entrySet()) {
            MemberSpans root = MemberSpans.of(edited, List.of());
            if (root.has(part)) {
                edited = MemberSpans.of(edited, List.of(part)).with(edited, value.getKey(), value.getValue());
            } else {
                String object = "{ \"" + value.getKey() + "\": " + value.getValue() + " }";
                edited = root.with(edited, part, object);
            }
        }
        return edited;
    }
}
