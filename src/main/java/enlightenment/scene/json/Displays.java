package enlightenment.scene.json;

import enlightenment.color.DisplayCurve;
import enlightenment.scene.Scene;
import enlightenment.scene.json.tree.JsonPointer;
import enlightenment.scene.json.tree.JsonValue;

/** Reads and writes the display part. */
final class Displays {
    private Displays() {}

    /** The display settings; null after a problem. */
    static Scene.Display read(JsonValue v, JsonPointer place, Values values) {
        Fields f = Fields.of(v, place, PartKeys.DISPLAY, values);
        if (f == null) {
            return null;
        }
        double exposure = f.number("exposure", Scene.Display.DEFAULT.exposure());
        DisplayCurve.Tone tone = f.word("tone", Scene.Display.DEFAULT.tone());
        return f.make(() -> new Scene.Display(exposure, tone));
    }

    static JsonObjectBuilder write(Scene.Display display, JsonObjectBuilder p) {
        return p.numberUnless(Scene.Display.DEFAULT.exposure(), "exposure", display.exposure())
                .wordUnless(Scene.Display.DEFAULT.tone(), "tone", display.tone());
    }
}
