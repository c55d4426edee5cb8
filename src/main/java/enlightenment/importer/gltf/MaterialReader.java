package enlightenment.importer.gltf;

import enlightenment.color.Rgb;
import enlightenment.importer.support.GlowingMaterial;
import enlightenment.importer.support.ImportNotes;
import enlightenment.material.Coated;
import enlightenment.material.Composite;
import enlightenment.material.Glass;
import enlightenment.material.Material;
import enlightenment.material.Principled;
import enlightenment.material.Texture;
import enlightenment.math.InvalidValueException;
import java.io.IOException;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;

/**
 * What a glTF material becomes: principled; with transmission, glass; unlit, matte. Opacity becomes a mask, which lets light pass by chance, and a
 * normal map stays one. What glows has neither.
 */
final class MaterialReader {
    private static final String CLEARCOAT = "KHR_materials_clearcoat";
    private static final String CLEARCOAT_ROUGHNESS = "clearcoatRoughnessTexture";
    private static final String EMISSIVE = "emissiveTexture";

    private static final List<String> LEFT_OUT = List.of(
            "KHR_materials_iridescence",
            "KHR_materials_anisotropy",
            "KHR_materials_diffuse_transmission",
            "KHR_materials_subsurface",
            "KHR_materials_volume_scatter");
    private static final String SPECULAR_GLOSSINESS = "KHR_materials_pbrSpecularGlossiness";
    private static final double USUAL_INDEX = 1.5;
    private static final double USUAL_CUTOFF = 0.5;

    private final GltfElement material;
    private final GltfTextures textures;
    private final ImportNotes notes;

    /** @param material without a value for that of primitives that name none */
    MaterialReader(GltfElement material, GltfTextures textures, ImportNotes notes) {
        this.material = material;
        this.textures = textures;
        this.notes = notes;
    }

    private void note(String message) {
        notes.add(material.place(), message);
    }

    private GltfElement metallicRoughness() throws IOException {
        return material.get("pbrMetallicRoughness");
    }

    private GltfElement specularGlossiness() throws IOException {
        return material.extension(SPECULAR_GLOSSINESS);
    }

    /** Whether its colour is that of the extension for specular and glossiness, for lack of another one. */
    private boolean isSpecularGlossiness() throws IOException {
        return specularGlossiness().isPresent() && !metallicRoughness().isPresent();
    }

    private GltfElement colorTexture() throws IOException {
        return isSpecularGlossiness()
                ? specularGlossiness().get("diffuseTexture")
                : metallicRoughness().get("baseColorTexture");
    }

    private GltfElement clearcoatRoughness() throws IOException {
        return material.extension(CLEARCOAT).get(CLEARCOAT_ROUGHNESS);
    }

    /** The texture coordinates that the mesh needs: those of its first texture, with a note where others have others. */
    Optional<TextureFrame> frame() throws IOException {
        Optional<TextureFrame> first = Optional.empty();
        for (GltfElement info : List.of(
                colorTexture(),
                metallicRoughness().get("metallicRoughnessTexture"),
                clearcoatRoughness(),
                material.get("normalTexture"),
                material.get(EMISSIVE))) {
            if (info.isPresent()) {
                TextureFrame frame = TextureFrame.of(info);
                if (first.isPresent() && !first.get().equals(frame)) {
                    note(
                            "its textures have different coordinates or KHR_texture_transform; all have those of the first");
                }
                first = first.isPresent() ? first : Optional.of(frame);
            }
        }
        return first;
    }

    /** Whether all textures repeat beyond 0..1. */
    boolean repeats() throws IOException {
        return textures.repeats(colorTexture())
                && textures.repeats(metallicRoughness().get("metallicRoughnessTexture"))
                && textures.repeats(clearcoatRoughness())
                && textures.repeats(material.get("normalTexture"))
                && textures.repeats(material.get(EMISSIVE));
    }

    /**
     * The material for meshes.
     *
     * @param closed whether they are closed, so that glass fills them
     */
    Material material(boolean closed) throws IOException {
        try {
            double[] factor = baseColor();
            Rgb tint = new Rgb(factor[0], factor[1], factor[2]);
            Texture color = textures.color(colorTexture(), tint).orElseGet(() -> Texture.of(tint));
            noteLosses();
            double share = transmitted();
            if (share > 0) {
                return masked(glass(color, share, closed), factor[3]);
            }
            if (material.extension("KHR_materials_unlit").isPresent()) {
                note("KHR_materials_unlit becomes matte: it is lit as all else is");
                return masked(Material.Matte.of(color), factor[3]);
            }
            return masked(withNormals(principled(color)), factor[3]);
        } catch (InvalidValueException e) {
            throw material.failure(e.getMessage());
        }
    }

    private double[] baseColor() throws IOException {
        double[] factor = isSpecularGlossiness()
                ? specularGlossiness().numbers("diffuseFactor", 1, 1, 1, 1)
                : metallicRoughness().numbers("baseColorFactor", 1, 1, 1, 1);
        for (int i = 0; i < factor.length; i++) {
            factor[i] = limited("the base colour", factor[i]);
        }
        return factor;
    }

    private double limited(String what, double v) {
        if (v < 0 || v > 1) {
            note(what + " is limited to 0..1");
        }
        return Math.min(Math.max(v, 0), 1);
    }

    private double share(GltfElement of, String key, double otherwise) throws IOException {
        return limited(key, of.number(key, otherwise));
    }

    private void noteLosses() throws IOException {
        for (String extension : LEFT_OUT) {
            if (material.extension(extension).isPresent()) {
                note(extension + " is left out");
            }
        }
        if (isSpecularGlossiness()) {
            note(SPECULAR_GLOSSINESS
                    + " becomes its diffuse colour under a coat: the colour of highlights is left out");
        }
    }

    private void noteTexture(GltfElement of, String key) throws IOException {
        if (of.has(key)) {
            note(key + " is left out: the factor holds everywhere");
        }
    }

    /** Whether what the material is on is filled: it transmits light and has a thickness. */
    boolean fillsVolume() throws IOException {
        return material.extension("KHR_materials_transmission").isPresent()
                && material.extension("KHR_materials_volume").number("thicknessFactor", 0) > 0;
    }

    /** The share that is transmitted: metal lets nothing through. */
    private double transmitted() throws IOException {
        GltfElement transmission = material.extension("KHR_materials_transmission");
        if (!transmission.isPresent()) {
            return 0;
        }
        boolean isTextured = metallicRoughness().has("metallicRoughnessTexture");
        double metallic = isSpecularGlossiness() ? 0 : share(metallicRoughness(), "metallicFactor", 1);
        double share = share(transmission, "transmissionFactor", 0);
        if (share == 0 || metallic == 1 && !isTextured) {
            return 0;
        }
        noteTexture(transmission, "transmissionTexture");
        if (isTextured && metallic > 0) {
            note("the metal of metallicRoughnessTexture is left out of what transmits light");
        }
        return share * (1 - (isTextured ? 0 : metallic));
    }

    private Material glass(Texture color, double share, boolean closed) throws IOException {
        GltfElement volume = material.extension("KHR_materials_volume");
        if (closed && volume.number("thicknessFactor", 0) == 0) {
            note("what transmits light and has no thickness is solid, not a thin wall: its mesh is closed");
        }
        if (material.has("normalTexture")) {
            note("normalTexture of what transmits light is left out");
        }
        if (!emitted().isBlack()) {
            note("the light of what transmits light is left out");
        }
        Texture.Amount roughness = amount(Texture.Amount.Channel.GREEN, roughnessFactor());
        if (!closed && !roughness.isZero()) {
            note("what transmits light is smooth: its mesh is not closed");
            roughness = Texture.Amount.of(0);
        }
        Glass glass = new Glass(color, index(), share, 0, true)
                .withRoughness(roughness)
                .withAbsorption(absorption(volume));
        return dispersing(share < 1 ? glass.withOpaque(opaqueShare(color, share)) : glass);
    }

    /** What a surface is made of that transmits only a share of light, where it does not: the metal, and the matte base. */
    private Material opaqueShare(Texture color, double share) throws IOException {
        Principled whole = principled(color);
        Principled rest = whole.metallic() instanceof Texture.Amount.Constant metal
                ? whole.withMetallic(Texture.Amount.of(Math.min(metal.value() / (1 - share), 1)))
                : whole;
        return GlowingMaterial.of(rest, Rgb.BLACK, Material.EmissionPattern.EVEN)
                .orElseThrow();
    }

    private Glass dispersing(Glass glass) throws IOException {
        double dispersion = material.extension("KHR_materials_dispersion").number("dispersion", 0);
        if (dispersion <= 0) {
            return glass;
        }
        try {
            // KHR_materials_dispersion: 20 / V.
            return glass.withDispersion(20 / dispersion);
        } catch (InvalidValueException e) {
            note("dispersion is left out: " + e.problem());
            return glass;
        }
    }

    /** Of what remains after the attenuation distance: exp(−absorption · distance) is the attenuation colour. */
    private Rgb absorption(GltfElement volume) throws IOException {
        double distance = volume.number("attenuationDistance", Double.POSITIVE_INFINITY);
        double[] color = volume.numbers("attenuationColor", 1, 1, 1);
        if (!(distance > 0)) {
            note("attenuationDistance is left out: it must be greater than 0");
            return Rgb.BLACK;
        }
        double[] a = new double[3];
        for (int i = 0; i < 3; i++) {
            // Nothing remains of a black band; the least float stands for it, since no coefficient is infinite.
            double left = Math.max(limited("attenuationColor", color[i]), Float.MIN_VALUE);
            a[i] = left == 1 ? 0 : -StrictMath.log(left) / distance;
        }
        return new Rgb(a[0], a[1], a[2]);
    }

    private double index() throws IOException {
        double ior = material.extension("KHR_materials_ior").number("ior", USUAL_INDEX);
        if (ior < 1 || ior > Coated.LARGEST_INDEX) {
            note("ior is limited to 1.." + (int) Coated.LARGEST_INDEX);
        }
        // 0 stands for a reflectance of 1.
        return ior == 0 ? Coated.LARGEST_INDEX : Math.min(Math.max(ior, 1), Coated.LARGEST_INDEX);
    }

    private double roughnessFactor() throws IOException {
        return isSpecularGlossiness()
                ? 1 - share(specularGlossiness(), "glossinessFactor", 1)
                : share(metallicRoughness(), "roughnessFactor", 1);
    }

    private Principled principled(Texture color) throws IOException {
        GltfElement specular = material.extension("KHR_materials_specular");
        GltfElement coat = material.extension(CLEARCOAT);
        noteTexture(specular, "specularTexture");
        if (specular.has("specularColorTexture") || specular.has("specularColorFactor")) {
            note("the colour of KHR_materials_specular is left out");
        }
        for (String key : List.of("clearcoatTexture", "clearcoatNormalTexture")) {
            noteTexture(coat, key);
        }
        double metallic = isSpecularGlossiness() ? 0 : share(metallicRoughness(), "metallicFactor", 1);
        return new Principled(
                color,
                amount(Texture.Amount.Channel.BLUE, metallic),
                amount(Texture.Amount.Channel.GREEN, roughnessFactor()),
                index(),
                share(specular, "specularFactor", 1),
                clearcoat(coat),
                sheen(),
                emitted(),
                0,
                Material.EmissionPattern.of(radianceMap()));
    }

    private Principled.Clearcoat clearcoat(GltfElement coat) throws IOException {
        return new Principled.Clearcoat(
                share(coat, "clearcoatFactor", 0),
                amount(
                        coat.get(CLEARCOAT_ROUGHNESS),
                        Texture.Amount.Channel.GREEN,
                        share(coat, "clearcoatRoughnessFactor", 0)));
    }

    /** Another lobe, and white: that of the file has a roughness and a colour of its own. */
    private Principled.Sheen sheen() throws IOException {
        GltfElement sheen = material.extension("KHR_materials_sheen");
        double share = 0;
        for (double component : sheen.numbers("sheenColorFactor", 0, 0, 0)) {
            share = Math.max(share, limited("sheenColorFactor", component));
        }
        if (share > 0) {
            note("KHR_materials_sheen becomes white sheen of another lobe, by the largest component of its factor");
        }
        return share == 0 ? Principled.Sheen.NONE : new Principled.Sheen(share, 0);
    }

    /** A channel of the metallic-roughness texture, if there is one. */
    private Texture.Amount amount(Texture.Amount.Channel channel, double factor) throws IOException {
        return amount(metallicRoughness().get("metallicRoughnessTexture"), channel, factor);
    }

    private Texture.Amount amount(GltfElement info, Texture.Amount.Channel channel, double factor) throws IOException {
        return factor == 0
                ? Texture.Amount.of(0)
                : textures.channel(info, channel, factor).orElseGet(() -> Texture.Amount.of(factor));
    }

    /** The radiance, before it is multiplied by a texture of several colours; black with one that cannot be had. */
    private Rgb emitted() throws IOException {
        double[] factor = material.numbers("emissiveFactor", 0, 0, 0);
        double strength = material.extension("KHR_materials_emissive_strength").number("emissiveStrength", 1);
        if (factor[0] < 0 || factor[1] < 0 || factor[2] < 0 || strength < 0) {
            throw material.failure("gives less light than none: emissiveFactor and emissiveStrength are at least 0");
        }
        Rgb radiance = new Rgb(factor[0] * strength, factor[1] * strength, factor[2] * strength);
        GltfElement texture = material.get(EMISSIVE);
        if (radiance.isBlack() || !texture.isPresent()) {
            return radiance;
        }
        Optional<Rgb> uniform = textures.uniform(texture);
        if (uniform.isPresent()) {
            return radiance.times(uniform.get());
        }
        return textures.color(texture, Rgb.WHITE).isPresent() ? radiance : Rgb.BLACK;
    }

    /** What the radiance is multiplied by; empty if all points glow alike, or not at all. */
    private Optional<Texture> radianceMap() throws IOException {
        GltfElement texture = material.get(EMISSIVE);
        boolean isUniform = !texture.isPresent()
                || textures.uniform(texture).isPresent()
                || emitted().isBlack();
        return isUniform ? Optional.empty() : textures.color(texture, Rgb.WHITE);
    }

    private Material withNormals(Principled surface) throws IOException {
        GltfElement info = material.get("normalTexture");
        if (!info.isPresent()) {
            return surface;
        }
        if (!surface.radiance().isBlack()) {
            note("normalTexture of what glows is left out");
            return surface;
        }
        Optional<Texture> normals = textures.normals(info, info.number("scale", 1));
        return normals.isPresent() ? new Composite.NormalMap(surface, normals.get()) : surface;
    }

    private Material masked(Material surface, double alpha) throws IOException {
        String mode = material.text("alphaMode", "OPAQUE");
        if (mode.equals("OPAQUE")) {
            return surface;
        }
        boolean isCut = mode.equals("MASK");
        OptionalDouble cutoff =
                isCut ? OptionalDouble.of(material.number("alphaCutoff", USUAL_CUTOFF)) : OptionalDouble.empty();
        Optional<Texture.Amount> map = textures.opacity(colorTexture(), alpha, cutoff);
        double constant = !isCut ? alpha : alpha >= cutoff.getAsDouble() ? 1 : 0;
        if (map.isEmpty() && constant == 1) {
            return surface;
        }
        if (surface instanceof Glass || !surface.radiance().isBlack()) {
            note("the opacity of what glows or transmits light is left out");
            return surface;
        }
        return new Composite.Mask(surface, map.orElseGet(() -> Texture.Amount.of(constant)));
    }
}
