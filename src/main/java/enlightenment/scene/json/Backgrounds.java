package enlightenment.scene.json;

import enlightenment.color.Rgb;
import enlightenment.material.Texture;
import enlightenment.scene.Shading;
import enlightenment.scene.json.tree.JsonPointer;
import enlightenment.scene.json.tree.JsonValue;
import java.util.List;
import java.util.Map;

/** Reads and writes backgrounds: a colour, a picture or a sky. */
final class Backgrounds {
    static final Family<Shading.Background> FAMILY = new Family<Shading.Background>(
                    "background", "surroundings", "picture", Map.of(), Backgrounds::read, Backgrounds::put)
            .with("picture", Shading.Background.Picture.class, "texture | radiance rotation")
            .with("sky", Shading.Background.Sky.class, "elevation | azimuth turbidity groundAlbedo radiance sun");

    /** The accepted forms of a background, for messages. */
    private static final String EXPECTED = Values.COLOR + ", [r, g, b] with components in 0..1, " + Values.LINEAR
            + ", a picture, {\"texture\": \"...\"}, or a sky, {\"type\": \"sky\", \"elevation\": degrees}";

    /** Keys that distinguish the forms given as objects. */
    private static final List<String> KINDS = List.of("linear", "texture", "type");

    private Backgrounds() {}

    /** The background; null after a problem of it or of its texture. */
    static Shading.Background read(JsonValue v, JsonPointer place, Values values) {
        if (v instanceof JsonValue.Obj o && KINDS.stream().allMatch(key -> o.get(key) == null)) {
            values.problems().add(v, place, "must be " + EXPECTED + ", not " + Values.describe(o, KINDS));
            return null;
        }
        if (!isMoreThanColor(v)) {
            Rgb radiance = values.color(v, place, EXPECTED).linear();
            return values.make(v, place, () -> new Shading.Background.Constant(radiance));
        }
        Fields f = Fields.of(v, place, FAMILY, values);
        return f == null ? null : FAMILY.read(f);
    }

    /** Whether a background is a picture or a sky. */
    static boolean isMoreThanColor(JsonValue v) {
        return v instanceof JsonValue.Obj o && (o.get("texture") != null || o.get("type") != null);
    }

    private static Shading.Background read(String type, Fields f) {
        return switch (type) {
            case "picture" -> picture(f);
            case "sky" -> sky(f);
            default -> throw Family.unknown(type);
        };
    }

    private static Shading.Background picture(Fields f) {
        Texture texture = f.has("texture") ? Textures.named(f) : null;
        Rgb radiance = f.bands("radiance", Rgb.WHITE);
        double rotation = f.number("rotation", 0);
        if (texture == null) {
            return null;
        }
        if (!(texture instanceof Texture.File file)) {
            f.problem("texture", "must name an image file: surroundings have no other textures");
            return null;
        }
        return f.make(() -> new Shading.Background.Picture(file, radiance, rotation));
    }

    private static Shading.Background sky(Fields f) {
        double elevation = f.number("elevation");
        double azimuth = f.number("azimuth", 0);
        double turbidity = f.number("turbidity", Shading.Background.Sky.USUAL_TURBIDITY);
        Rgb ground = f.bands("groundAlbedo", Shading.Background.Sky.USUAL_GROUND);
        Rgb radiance = f.bands("radiance", Rgb.WHITE);
        boolean sun = f.flag("sun", true);
        return f.make(() -> new Shading.Background.Sky(elevation, azimuth, turbidity, ground, radiance, sun));
    }

    static JsonValue write(Shading.Background background, JsonObjectBuilder p) {
        if (background instanceof Shading.Background.Constant c) {
            return p.linear("linear", c.radiance()).json();
        }
        FAMILY.write(background, p);
        return p.json();
    }

    private static void put(Shading.Background value, JsonObjectBuilder p) {
        if (value instanceof Shading.Background.Picture s) {
            p.textureName("texture", s.picture())
                    .bandsUnless(Rgb.WHITE, "radiance", s.radiance())
                    .numberUnless(0, "rotation", s.rotation());
        } else if (value instanceof Shading.Background.Sky s) {
            p.number("elevation", s.elevation())
                    .numberUnless(0, "azimuth", s.azimuth())
                    .numberUnless(Shading.Background.Sky.USUAL_TURBIDITY, "turbidity", s.turbidity())
                    .bandsUnless(Shading.Background.Sky.USUAL_GROUND, "groundAlbedo", s.groundAlbedo())
                    .bandsUnless(Rgb.WHITE, "radiance", s.radiance())
                    .flagUnless(true, "sun", s.hasSun());
        } else {
            throw Family.unknown(value);
        }
    }
}
