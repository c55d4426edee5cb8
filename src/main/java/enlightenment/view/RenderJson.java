package enlightenment.view;

import enlightenment.json.JsonText;
import enlightenment.scene.Method;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import java.util.List;
import java.util.Locale;

/** The status of final renders as JSON; docs/guide/view.md describes it. */
final class RenderJson {
    private RenderJson() {}

    /**
     * The status of a render, with the default size and the methods of the next one.
     *
     * @param scene the scene of the view; null if none has been read yet
     */
    static String of(RenderStatus s, Scene scene) {
        return JsonText.of(json -> {
            json.writeStartObject();
            json.writeNumberProperty("version", s.version());
            json.writeStringProperty("state", s.state().name().toLowerCase(Locale.ROOT));
            json.writeNumberProperty("done", s.done());
            json.writeNumberProperty("seconds", s.seconds());
            json.writeNumberProperty("width", s.width());
            json.writeNumberProperty("height", s.height());
            json.writeArrayPropertyStart("notes");
            s.notes().forEach(json::writeString);
            json.writeEndArray();
            json.writeObjectPropertyStart("scene");
            json.writeNumberProperty("width", scene == null ? 0 : scene.width());
            json.writeNumberProperty("height", scene == null ? 0 : scene.height());
            json.writeStringProperty(
                    "method",
                    scene == null ? "" : RenderSettings.of(scene).method().word());
            json.writeArrayPropertyStart("methods");
            methods(scene).forEach(m -> json.writeString(m.word()));
            json.writeEndArray();
            json.writeEndObject();
            json.writeEndObject();
        });
    }

    private static List<Method> methods(Scene scene) {
        return scene == null
                ? List.of()
                : Method.selectable().stream()
                        .filter(m -> Method.supports(m, scene))
                        .toList();
    }
}
