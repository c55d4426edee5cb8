package enlightenment.material;

import enlightenment.check.Check;
import enlightenment.color.Rgb;
import enlightenment.colorimetry.BandSensitivities;
import enlightenment.colorimetry.CauchyFormula;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalDouble;

/**
 * Glass: light is refracted by Snell's law, or totally reflected; in physical shading Fresnel's equations say how much is
 * reflected.
 *
 * @param color multiplied onto what is seen through the surface, each time a ray crosses it; not onto what it reflects
 * @param indexOfRefraction relative to the surrounding medium (1), greater than 0
 * @param transparency the share of what is seen that comes through: 0 (an opaque surface) to 1 (clear)
 * @param priority where solids overlap, the one of higher priority fills the overlap; at equal priorities, the one of less volume
 *     (Schmidt and Budge, "Simple nested dielectrics in ray traced images", 2002)
 * @param receivesShadows whether shadows show on the opaque share
 * @param roughness of the surface, 0 (smooth) to 1; the parameter alpha of the distribution GGX is its square
 * @param absorption the share that is lost per scene unit inside the solid, for small shares: light decays by exp(−absorption ·
 *     length) (Beer and Lambert)
 * @param multipleScattering whether light that meets several facets of a rough surface is counted
 * @param dispersion the Abbe number V_d = (n_d − 1) / (n_F − n_C), where n_d is {@code indexOfRefraction}: greater than 0, and such
 *     that the index is positive at all visible wavelengths (Cauchy's formula of two terms). About 60 for crown glass, 36 for flint
 *     glass; a smaller number disperses more. Empty: the index does not depend on the wavelength
 * @param smoothRefraction whether, in physical shading, a closed mesh with normals at its vertices refracts and reflects by these,
 *     interpolated, and not by the normals of its triangles; all other shapes refract by their own normal. Needs roughness 0
 * @param opaque what, in physical shading, the opaque share of the surface is made of: matte, glossy, coated or principled, and without light
 *     of its own. Empty: matte, of the same colour. Needs a transparency below 1
 */
public record Glass(
        Texture color,
        double indexOfRefraction,
        double transparency,
        int priority,
        boolean receivesShadows,
        Texture.Amount roughness,
        Rgb absorption,
        boolean multipleScattering,
        OptionalDouble dispersion,
        boolean smoothRefraction,
        Optional<Material> opaque)
        implements Material {
    /** Validates the components, as {@link Material} states. */
    public Glass {
        Reflectance.check(color);
        Check.positive("indexOfRefraction", indexOfRefraction);
        Check.range("transparency", transparency, 0, 1);
        Objects.requireNonNull(roughness, "roughness");
        Objects.requireNonNull(absorption, "absorption");
        if (dispersion.isPresent()) {
            checkDispersion(indexOfRefraction, dispersion.getAsDouble());
        }
        Check.that(
                !smoothRefraction || roughness.isZero(),
                "smoothRefraction",
                "must stand without \"roughness\": rough glass refracts by the normals of its triangles");
        opaque.ifPresent(base -> checkOpaque(base, transparency));
    }

    private static void checkOpaque(Material base, double transparency) {
        boolean mayBe = base instanceof Material.Matte
                || base instanceof Glossy
                || base instanceof Coated
                || base instanceof Principled;
        Check.that(mayBe, "opaque", "must be matte, glossy, coated or principled, not " + base.type());
        Detail.check("opaque", base);
        Check.that(transparency < 1, "opaque", "must stand with a \"transparency\" below 1");
    }

    private static void checkDispersion(double index, double abbe) {
        Check.positive("dispersion", abbe);
        double slope = CauchyFormula.slope(index, abbe);
        double violet = CauchyFormula.index(index, slope, CauchyFormula.place(BandSensitivities.SHORTEST));
        double red = CauchyFormula.index(index, slope, CauchyFormula.place(BandSensitivities.LONGEST));
        Check.that(
                violet > 0 && red > 0 && violet < Double.POSITIVE_INFINITY && red < Double.POSITIVE_INFINITY,
                "dispersion",
                "is too small: indices of refraction must be positive, but would be " + violet
                        + " at the violet end and " + red + " at the red end of visible light");
    }

    /** Smooth glass that absorbs nothing. */
    public Glass(Texture color, double indexOfRefraction, double transparency, int priority, boolean receivesShadows) {
        this(
                color,
                indexOfRefraction,
                transparency,
                priority,
                receivesShadows,
                Texture.Amount.of(0),
                Rgb.BLACK,
                true,
                OptionalDouble.empty(),
                false,
                Optional.empty());
    }

    /** Clear, smooth glass of this filter colour and index of refraction, priority 0. */
    public static Glass of(Texture color, double indexOfRefraction) {
        return new Glass(color, indexOfRefraction, 1, 0, true);
    }

    /** This glass with another roughness, everywhere. */
    public Glass withRoughness(double value) {
        return withRoughness(Detail.amount("roughness", value));
    }

    /** This glass with another roughness, which may depend on the place. */
    public Glass withRoughness(Texture.Amount value) {
        return with(value, absorption, multipleScattering, dispersion, smoothRefraction, opaque);
    }

    /** This glass with another {@link #absorption()}. */
    public Glass withAbsorption(Rgb value) {
        return with(roughness, value, multipleScattering, dispersion, smoothRefraction, opaque);
    }

    /** This glass with another {@link #multipleScattering()}. */
    public Glass withMultipleScattering(boolean value) {
        return with(roughness, absorption, value, dispersion, smoothRefraction, opaque);
    }

    /** This glass with this Abbe number. */
    public Glass withDispersion(double value) {
        return with(roughness, absorption, multipleScattering, OptionalDouble.of(value), smoothRefraction, opaque);
    }

    /** This glass with another {@link #smoothRefraction()}; needs roughness 0 if true. */
    public Glass withSmoothRefraction(boolean value) {
        return with(roughness, absorption, multipleScattering, dispersion, value, opaque);
    }

    /** This glass, whose opaque share is made of this: see {@link #opaque()}. */
    public Glass withOpaque(Material value) {
        return with(roughness, absorption, multipleScattering, dispersion, smoothRefraction, Optional.of(value));
    }

    private Glass with(
            Texture.Amount rough,
            Rgb absorbed,
            boolean several,
            OptionalDouble abbe,
            boolean smoothly,
            Optional<Material> base) {
        return new Glass(
                color,
                indexOfRefraction,
                transparency,
                priority,
                receivesShadows,
                rough,
                absorbed,
                several,
                abbe,
                smoothly,
                base);
    }

    @Override
    public List<Texture> textures() {
        return roughness.textures();
    }

    @Override
    public List<Material> parts() {
        return opaque.map(List::of).orElse(List.of());
    }

    @Override
    public String type() {
        return "glass";
    }

    @Override
    public boolean isForClassicShading() {
        return true;
    }
}
