package enlightenment.scene.json;

import enlightenment.material.Texture;
import enlightenment.scene.json.tree.JsonValue;

/** Numbers in 0..1 that may come from a texture. */
final class Amounts {
    private static final String EXPECTED = "a number in 0..1, or {\"texture\": NAME}";

    private Amounts() {}

    /** A required amount; null if it is missing, and after a problem. */
    static Texture.Amount read(Fields f, String key) {
        if (!f.has(key)) {
            return null;
        }
        if (f.get(key) instanceof JsonValue.Obj) {
            return textured(f, key);
        }
        if (!(f.get(key) instanceof JsonValue.Num)) {
            f.problem(key, "must be " + EXPECTED + ", not " + f.get(key).describe());
            return null;
        }
        double value = f.number(key);
        if (!(value >= 0 && value <= 1)) {
            f.problem(key, "must lie in 0.0..1.0, not " + value);
            return null;
        }
        return Texture.Amount.of(value);
    }

    /** An optional amount; null after a problem. */
    static Texture.Amount read(Fields f, String key, double unlessGiven) {
        return f.has(key) ? read(f, key) : Texture.Amount.of(unlessGiven);
    }

    private static Texture.Amount textured(Fields f, String key) {
        Fields reference = Fields.of(f.get(key), f.at(key), PartKeys.AMOUNT_REFERENCE, f.values());
        if (reference == null || !reference.has("texture")) {
            return null;
        }
        Texture texture = Textures.ofSurface(reference);
        Texture.Amount.Channel channel = reference.word("channel", Texture.Amount.Channel.MEAN);
        double factor = reference.number("factor", 1);
        return texture == null ? null : reference.make(() -> new Texture.Amount.Textured(texture, channel, factor));
    }
}
