package enlightenment.importer.pbrt;

import enlightenment.color.Rgb;
import enlightenment.importer.support.ImportNotes;
import enlightenment.material.Coated;
import enlightenment.material.Glossy;
import enlightenment.material.Material;
import enlightenment.material.Texture;
import java.util.Map;
import java.util.Optional;

/** Materials that light does not pass: diffuse, conductors, layers over them, and what is approximated by a matte surface. */
final class OpaqueMaterials {
    /** Of a conductor whose reflectance is given: less than all, so that k is finite. */
    private static final double MOST_REFLECTANCE = 0.9999;

    private static final Rgb USUAL_REFLECTANCE = Rgb.gray(0.5);

    /** A brown, for hair. */
    private static final Rgb HAIR = new Rgb(0.15, 0.08, 0.04);

    private final Textures textures;
    private final Spectra spectra;
    private final ImportNotes notes;
    private final Roughness roughness;

    OpaqueMaterials(Textures textures, Spectra spectra, ImportNotes notes) {
        this.textures = textures;
        this.spectra = spectra;
        this.notes = notes;
        roughness = new Roughness(textures, notes);
    }

    void addTo(Map<String, Materials.SurfaceMaker> makers) {
        makers.put("diffuse", (source, uv) -> Material.Matte.of(reflectance(source, uv, USUAL_REFLECTANCE)));
        makers.put("coateddiffuse", this::coated);
        makers.put("conductor", (source, uv) -> conductor(source, uv, ""));
        makers.put("coatedconductor", (source, uv) -> {
            note(source, "the coat of a coated conductor is left out");
            return conductor(source, uv, "conductor.");
        });
        makers.put("diffusetransmission", (source, uv) -> {
            note(source, "what a surface transmits diffusely is left out; it becomes matte of its reflectance");
            ResolvedTexture t = textures.color(source.parameters(), "reflectance", source.space(), Rgb.gray(0.25));
            return Material.Matte.of(
                    uv.color(t.times(Rgb.gray(source.parameters().number("scale", 1)))));
        });
        makers.put("hair", (source, uv) -> {
            note(source, "hair becomes matte");
            return Material.Matte.of(Texture.of(HAIR));
        });
        makers.put("measured", (source, uv) -> {
            note(source, "a measured material becomes matte grey");
            return Material.Matte.of(Texture.of(USUAL_REFLECTANCE));
        });
    }

    private void note(MaterialSource source, String message) {
        notes.add(source.parameters().place().shown(), message);
    }

    private Texture reflectance(MaterialSource source, UvChoice uv, Rgb usual) {
        return uv.color(textures.color(source.parameters(), "reflectance", source.space(), usual));
    }

    /** Light that goes to and fro in the layers takes the base's colour each time, as in pbrt's random walk. */
    private Material coated(MaterialSource source, UvChoice uv) {
        Parameters p = source.parameters();
        if (textures.color(p, "albedo", source.space(), Rgb.BLACK).isSolid()
                && !textures.color(p, "albedo", source.space(), Rgb.BLACK)
                        .color()
                        .equals(Rgb.BLACK)) {
            note(source, "scattering inside of a coat is left out");
        }
        double eta = spectra.rgb(p, "eta", Spectra.Kind.UNBOUNDED, source.space(), Rgb.gray(Coated.USUAL_INDEX))
                .g();
        double index = Math.min(Math.max(eta, 1), Coated.LARGEST_INDEX);
        Texture base = reflectance(source, uv, USUAL_REFLECTANCE);
        return new Coated(base, roughness.amount(p, "", uv), index, true, Rgb.BLACK, 0);
    }

    private Material conductor(MaterialSource source, UvChoice uv, String prefix) {
        Parameters p = source.parameters();
        if (p.has("reflectance")) {
            ResolvedTexture r = textures.color(p, "reflectance", source.space(), USUAL_REFLECTANCE);
            if (!r.isSolid()) {
                note(source, "a conductor whose reflectance is a texture reflects by Schlick's approximation");
                Texture color = uv.color(r);
                return new Glossy(color, roughness.amount(p, prefix, uv), Optional.empty(), false, Rgb.BLACK, 0);
            }
            return metal(ofReflectance(r.color()), roughness.amount(p, prefix, uv));
        }
        Glossy.Conductor copper = Glossy.Metal.COPPER.conductor();
        Rgb eta = spectra.rgb(p, prefix + "eta", Spectra.Kind.UNBOUNDED, source.space(), copper.eta());
        Rgb k = spectra.rgb(p, prefix + "k", Spectra.Kind.UNBOUNDED, source.space(), copper.k());
        return metal(new Glossy.Conductor(eta, k), roughness.amount(p, prefix, uv));
    }

    private static Material metal(Glossy.Conductor conductor, Texture.Amount rough) {
        return new Glossy(Texture.of(Rgb.WHITE), rough, Optional.of(conductor), false, Rgb.BLACK, 0);
    }

    /** As pbrt has it: eta is 1, and k such that the reflectance straight on is the given one. */
    private static Glossy.Conductor ofReflectance(Rgb r) {
        return new Glossy.Conductor(Rgb.WHITE, new Rgb(k(r.r()), k(r.g()), k(r.b())));
    }

    private static double k(double reflectance) {
        double r = Math.min(reflectance, MOST_REFLECTANCE);
        return 2 * StrictMath.sqrt(r) / StrictMath.sqrt(1 - r);
    }
}
