package enlightenment.scene.json;

import enlightenment.scene.Animation;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.ChosenSettings;
import enlightenment.scene.Method;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.json.tree.JsonPointer;
import enlightenment.scene.json.tree.JsonValue;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/** Reads and writes the render part, whose methods and settings are those of the registry. */
final class RenderPart {
    private RenderPart() {}

    /** The keys of the render part, with the settings of the given methods. */
    static Keys keys(List<Method> methods) {
        StringBuilder optional = new StringBuilder("method antialias");
        for (Method.Setting setting : Method.settings(methods)) {
            optional.append(' ').append(setting.key());
        }
        return Keys.of("render", "the render part", "", optional.toString());
    }

    /** The render defaults; null after a problem. */
    static RenderSettings.Defaults read(JsonValue v, JsonPointer place, Values values) {
        List<Method> methods = known(v);
        Fields f = Fields.of(v, place, keys(methods), values);
        if (f == null) {
            return null;
        }
        RenderSettings.Defaults d = RenderSettings.Defaults.DEFAULT;
        String method = f.word(
                "method", Method.words(Method.selectable(methods)), d.method().word());
        int antialias = f.integer("antialias", 1, RenderSettings.Defaults.MAX_ANTIALIAS, d.antialias());
        ChosenSettings chosen = ChosenSettings.NONE;
        for (Method.Setting setting : Method.settings(methods)) {
            Object value = f.has(setting.key()) ? value(f, setting) : null;
            chosen = value == null ? chosen : chosen.with(setting, value);
        }
        ChosenSettings said = chosen;
        return f.make(() -> new RenderSettings.Defaults(Method.named(method), antialias, said));
    }

    /** The built-in methods; if a key or the method is not built in, all methods. Extensions are thus loaded on demand. */
    private static List<Method> known(JsonValue v) {
        if (v instanceof JsonValue.Obj o) {
            Keys own = keys(BuiltInMethod.ALL);
            for (String key : o.keys()) {
                if (!own.has(key)) {
                    return Method.all();
                }
            }
            if (o.get("method") instanceof JsonValue.Str s
                    && !Method.words(Method.selectable(BuiltInMethod.ALL)).contains(s.text)) {
                return Method.all();
            }
        }
        return BuiltInMethod.ALL;
    }

    /** The value of a setting that is present; null after a problem. */
    private static Object value(Fields f, Method.Setting setting) {
        return setting instanceof Method.Setting.Whole w
                ? (Object) f.whole(w.key(), w.min(), w.max(), w.usualValue())
                : f.word(setting.key(), ((Method.Setting.Word) setting).words(), null);
    }

    /**
     * Writes the chosen settings. Whole numbers that influence the method or are targets of tracks are written even with default values.
     *
     * @param animation null if there is none
     */
    static JsonValue write(RenderSettings.Defaults r, Animation animation, JsonObjectBuilder p) {
        p.text("method", r.method().word()).whole("antialias", r.antialias());
        Map<String, Object> chosen = new TreeMap<>(r.chosen().values());
        List<Method.Setting> own = Method.influences(r.method());
        for (Method.Setting setting : Method.settings(BuiltInMethod.ALL)) {
            boolean isSaid = own.contains(setting) || isMoved(setting, animation);
            if (chosen.containsKey(setting.key()) || isSaid && setting instanceof Method.Setting.Whole) {
                put(p, setting.key(), r.chosen().value(setting));
                chosen.remove(setting.key());
            }
        }
        chosen.forEach((key, value) -> put(p, key, value));
        return p.json();
    }

    private static boolean isMoved(Method.Setting setting, Animation animation) {
        String place = JsonPointer.ROOT.child("render").child(setting.key()).toString();
        return animation != null
                && animation.tracks().stream().anyMatch(track -> track.target().equals(place));
    }

    private static void put(JsonObjectBuilder p, String key, Object value) {
        if (value instanceof Long whole) {
            p.whole(key, whole);
        } else {
            p.text(key, (String) value);
        }
    }
}
