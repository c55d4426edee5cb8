package enlightenment.importer.pbrt;

import enlightenment.color.Rgb;
import enlightenment.importer.support.ImportNotes;
import enlightenment.material.Glass;
import enlightenment.material.Material;
import enlightenment.material.Medium;
import enlightenment.material.Texture;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;

/** Materials that light passes: dielectrics and what scatters below its surface. */
final class ClearMaterials {
    private static final double USUAL_INDEX = 1.5;
    private static final double SUBSURFACE_INDEX = 1.33;

    /** pbrt's coefficients of a subsurface material that says none, per millimetre of its unit. */
    private static final Rgb USUAL_ABSORPTION = new Rgb(0.0011, 0.0024, 0.014);

    private static final Rgb USUAL_SCATTERING = new Rgb(2.55, 3.21, 3.77);

    private final Textures textures;
    private final Spectra spectra;
    private final ImportNotes notes;
    private final Roughness roughness;

    ClearMaterials(Textures textures, Spectra spectra, ImportNotes notes) {
        this.textures = textures;
        this.spectra = spectra;
        this.notes = notes;
        roughness = new Roughness(textures, notes);
    }

    void addTo(Map<String, Materials.SurfaceMaker> makers) {
        makers.put("dielectric", (source, uv) -> glass(source, roughness.amount(source.parameters(), "", uv)));
        makers.put("thindielectric", (source, uv) -> glass(source, Texture.Amount.of(0)));
        makers.put("subsurface", this::subsurface);
    }

    private Material glass(MaterialSource source, Texture.Amount rough) {
        Optional<NamedSpectra.GlassType> named = source.parameters()
                .find("eta")
                .filter(p -> p.type().equals("spectrum") && p.words().size() == 1)
                .flatMap(p -> NamedSpectra.glass(p.words().get(0)));
        double index = named.map(NamedSpectra.GlassType::index).orElseGet(() -> index(source, USUAL_INDEX));
        Glass glass =
                Glass.of(Texture.of(Rgb.WHITE), index).withRoughness(rough).withMultipleScattering(false);
        OptionalDouble abbe = named.map(NamedSpectra.GlassType::abbe).orElse(OptionalDouble.empty());
        return abbe.isPresent() ? glass.withDispersion(abbe.getAsDouble()) : glass;
    }

    private double index(MaterialSource source, double usual) {
        return spectra.rgb(source.parameters(), "eta", Spectra.Kind.UNBOUNDED, source.space(), Rgb.gray(usual))
                .g();
    }

    private Material subsurface(MaterialSource source, UvChoice uv) {
        Parameters p = source.parameters();
        double scale = p.positive("scale", 1);
        double g = Math.min(Math.max(p.number("g", 0), -0.99), 0.99);
        Medium medium;
        if (p.has("reflectance")) {
            Rgb path = spectra.rgb(p, "mfp", Spectra.Kind.UNBOUNDED, source.space(), Rgb.WHITE);
            medium = new Medium.Colored(meanReflectance(source), path.times(Rgb.gray(scale)), g);
        } else {
            if (p.has("name")) {
                notes.add(p.place().shown(), "a subsurface material by name gets the usual coefficients");
            }
            medium = new Medium.Coefficients(
                    coefficient(source, "sigma_s", USUAL_SCATTERING, scale),
                    coefficient(source, "sigma_a", USUAL_ABSORPTION, scale),
                    g);
        }
        return new Material.Scattering(medium, index(source, SUBSURFACE_INDEX), roughness.of(p, ""), 0);
    }

    private Rgb meanReflectance(MaterialSource source) {
        Parameters p = source.parameters();
        ResolvedTexture t = textures.color(p, "reflectance", source.space(), Rgb.WHITE);
        return t.isSolid()
                ? t.color()
                : Rgb.gray(Math.min(1, textures.mean(t, p.place(), "the colour of a subsurface material")));
    }

    private Rgb coefficient(MaterialSource source, String name, Rgb usual, double scale) {
        return spectra.rgb(source.parameters(), name, Spectra.Kind.UNBOUNDED, source.space(), usual)
                .times(Rgb.gray(scale));
    }
}
