package enlightenment.scene.json;

import enlightenment.color.DisplayCurve;
import enlightenment.scene.Display;

/** Reads and writes the display part. */
final class Displays {
    private Displays() {}

    /** Null after a problem. */
    static Display read(JsonValue v, JsonPointer place, Values values) {
        Fields f = Fields.of(v, place, PartKeys.DISPLAY, values);
        if (f == null) {
            return null;
        }
        double exposure = f.number("exposure", Display.DEFAULT.exposure());
        DisplayCurve.Tone tone = f.word("tone", Display.DEFAULT.tone());
        return f.make(() -> new Display(exposure, tone));
    }

    static JsonObjectBuilder write(Display display, JsonObjectBuilder p) {
        return p.numberUnless(Display.DEFAULT.exposure(), "exposure", display.exposure())
                .wordUnless(Display.DEFAULT.tone(), "tone", display.tone());
    }
}
