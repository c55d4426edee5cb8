package enlightenment.importer.model;

import enlightenment.color.Rgb;
import enlightenment.importer.support.ImportNotes;
import enlightenment.importer.support.InputFolder;
import enlightenment.material.Coated;
import enlightenment.material.Composite;
import enlightenment.material.Glass;
import enlightenment.material.Material;
import enlightenment.material.Texture;
import enlightenment.math.Vec3;
import enlightenment.mesh.input.MtlFile;
import enlightenment.text.Plain;
import java.io.IOException;
import java.util.Optional;

/**
 * What a material of an MTL file becomes: by its illumination model mirror or glass; with a highlight a coat over matte, else matte; with an opacity
 * below 1 or a texture of it cut out by chance. Numbers are linear, textures of
 * colour and of emitted light sRGB; where only a texture says what is emitted, the number is 1.
 */
final class MtlMaterial {
    /** Of glass whose index is not said, and of coats. */
    private static final double USUAL_INDEX = 1.5;

    private final MtlFile.Material mtl;
    private final InputFolder folder;
    private final ImportNotes notes;

    MtlMaterial(MtlFile.Material mtl, InputFolder folder, ImportNotes notes) {
        this.mtl = mtl;
        this.folder = folder;
        this.notes = notes;
    }

    Material material() {
        int model = mtl.illum().orElse(2);
        boolean isGlass = model == 4 || model == 6 || model == 7 || model == 9;
        if (isGlass) {
            double index = mtl.ni().orElse(USUAL_INDEX);
            return Glass.of(Texture.of(Rgb.WHITE), index > 1 ? index : USUAL_INDEX);
        }
        if (model == 3 || model == 5 || model == 8) {
            return Material.Mirror.of(Texture.of(clamped(mtl.ks().orElse(new Vec3(1, 1, 1)), 1)));
        }
        return cutOut(opaque());
    }

    private Material opaque() {
        Texture color = mtl.mapKd()
                .flatMap(name -> texture(name, Texture.Encoding.SRGB))
                .orElseGet(() -> Texture.of(clamped(mtl.kd().orElse(new Vec3(0.6, 0.6, 0.6)), 1)));
        if (mtl.mapKd().isPresent() && mtl.kd().filter(this::isTint).isPresent()) {
            notes.add("", "Kd of materials with map_Kd is left out: " + Plain.quoted(mtl.name()));
        }
        Optional<Texture> map = mtl.mapKe().flatMap(name -> texture(name, Texture.Encoding.SRGB));
        Rgb usual = map.isPresent() ? Rgb.WHITE : Rgb.BLACK;
        Rgb radiance = mtl.ke().map(ke -> clamped(ke, Float.MAX_VALUE)).orElse(usual);
        if (radiance.isBlack()) {
            map = Optional.empty();
        }
        boolean isShiny = mtl.ks().filter(ks -> ks.maxAbs() > 0).isPresent()
                && mtl.ns().orElse(0) > 0
                && mtl.illum().orElse(2) >= 2;
        if (!isShiny) {
            return new Material.Matte(color, true, 0, radiance, 0, Material.EmissionPattern.of(map));
        }
        // Blinn's exponent n has the width of the distribution of alpha² = 2 / (n + 2) (Walter et al. 2007); roughness
        // is the root of alpha.
        double alpha = StrictMath.sqrt(2 / (mtl.ns().getAsDouble() + 2));
        return new Coated(
                color,
                Texture.Amount.of(StrictMath.sqrt(alpha)),
                USUAL_INDEX,
                false,
                radiance,
                0,
                Material.EmissionPattern.of(map));
    }

    private boolean isTint(Vec3 kd) {
        return kd.maxAbs() != 0 && !kd.equals(new Vec3(1, 1, 1));
    }

    private Material cutOut(Material opaque) {
        Optional<Texture> map = mtl.mapD().flatMap(name -> texture(name, Texture.Encoding.LINEAR));
        double d = Math.min(Math.max(mtl.d().orElse(1), 0), 1);
        if (map.isEmpty() && d == 1) {
            return opaque;
        }
        if (!opaque.radiance().isBlack()) {
            notes.add("", "the opacity of what glows is left out: " + Plain.quoted(mtl.name()));
            return opaque;
        }
        return new Composite.Mask(opaque, map.orElseGet(() -> Texture.of(new Rgb(d, d, d))));
    }

    private Optional<Texture> texture(String name, Texture.Encoding encoding) {
        try {
            return Optional.of(new Texture.File(folder.file(name), Texture.Filter.BILINEAR, encoding));
        } catch (IOException e) {
            notes.add("", "a texture is left out: " + e.getMessage());
            return Optional.empty();
        }
    }

    /** Files are not trusted: what is no number becomes 0. */
    private static Rgb clamped(Vec3 v, double most) {
        return new Rgb(clamped(v.x(), most), clamped(v.y(), most), clamped(v.z(), most));
    }

    private static double clamped(double v, double most) {
        return v > 0 ? Math.min(v, most) : 0;
    }
}
