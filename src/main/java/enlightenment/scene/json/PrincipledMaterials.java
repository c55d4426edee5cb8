package enlightenment.scene.json;

import enlightenment.color.Rgb;
import enlightenment.material.Coated;
import enlightenment.material.Material;
import enlightenment.material.Principled;
import enlightenment.material.Texture;

/** Materials of metallic-roughness workflows. */
final class PrincipledMaterials {
    static final String KEYS =
            "color | metallic roughness indexOfRefraction specular clearcoat clearcoatRoughness sheen sheenTint radiance"
                    + " radianceMap radianceSide ultraviolet";

    private PrincipledMaterials() {}

    /** The material; null after a problem. */
    static Material read(Fields f) {
        Texture color = Textures.color(f, "color");
        Texture.Amount metallic = Amounts.read(f, "metallic", 0);
        Texture.Amount roughness = Amounts.read(f, "roughness", Principled.USUAL_ROUGHNESS);
        double index = f.number("indexOfRefraction", Coated.USUAL_INDEX);
        double specular = f.number("specular", 1);
        double clearcoat = f.number("clearcoat", 0);
        Texture.Amount clearcoatRoughness = Amounts.read(f, "clearcoatRoughness", 0);
        double sheen = f.number("sheen", 0);
        double sheenTint = f.number("sheenTint", 0);
        Rgb radiance = Materials.radiance(f);
        Material.EmissionPattern pattern = Materials.pattern(f);
        double ultraviolet = f.number("ultraviolet", 0);
        if (color == null || metallic == null || roughness == null || clearcoatRoughness == null) {
            return null;
        }
        return f.make(() -> new Principled(
                color,
                metallic,
                roughness,
                index,
                specular,
                new Principled.Clearcoat(clearcoat, clearcoatRoughness),
                new Principled.Sheen(sheen, sheenTint),
                radiance,
                ultraviolet,
                pattern));
    }

    static void write(Principled m, JsonObjectBuilder p) {
        p.texture("color", m.color())
                .amountUnless(0, "metallic", m.metallic())
                .amountUnless(Principled.USUAL_ROUGHNESS, "roughness", m.roughness())
                .numberUnless(Coated.USUAL_INDEX, "indexOfRefraction", m.indexOfRefraction())
                .numberUnless(1, "specular", m.specular())
                .numberUnless(0, "clearcoat", m.clearcoat().share())
                .amountUnless(0, "clearcoatRoughness", m.clearcoat().roughness())
                .numberUnless(0, "sheen", m.sheen().share())
                .numberUnless(0, "sheenTint", m.sheen().tint())
                .bandsUnless(Rgb.BLACK, "radiance", m.radiance())
                .textureIfPresent("radianceMap", m.radianceMap())
                .wordUnless(
                        Material.EmissionPattern.Side.BOTH,
                        "radianceSide",
                        m.pattern().side())
                .numberUnless(0, "ultraviolet", m.ultraviolet());
    }
}
