package enlightenment.scene.json;

import enlightenment.material.Amount;
import enlightenment.material.Texture;

/** Numbers in 0..1 that may come from a texture. */
final class Amounts {
    private static final String EXPECTED = "a number in 0..1, or {\"texture\": NAME}";

    private Amounts() {}

    /** An amount that must be there; null where it is missing, and after a problem. */
    static Amount read(Fields f, String key) {
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
        return Amount.of(value);
    }

    /** An amount that may be missing; null after a problem. */
    static Amount read(Fields f, String key, double unlessGiven) {
        return f.has(key) ? read(f, key) : Amount.of(unlessGiven);
    }

    private static Amount textured(Fields f, String key) {
        Fields reference = Fields.of(f.get(key), f.at(key), PartKeys.AMOUNT_REFERENCE, f.values());
        if (reference == null || !reference.has("texture")) {
            return null;
        }
        Texture texture = Textures.ofSurface(reference);
        Amount.Channel channel = reference.word("channel", Amount.Channel.MEAN);
        double factor = reference.number("factor", 1);
        return texture == null ? null : reference.make(() -> new Amount.Textured(texture, channel, factor));
    }
}
