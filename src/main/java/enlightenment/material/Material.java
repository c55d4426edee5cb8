package enlightenment.material;

import enlightenment.check.Check;
import enlightenment.color.BandSensitivities;
import enlightenment.color.CauchyFormula;
import enlightenment.color.Radiance;
import enlightenment.color.Rgb;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalDouble;

/**
 * What a surface does with light: an immutable description. Classic shading ignores what only physical shading knows of a
 * material: roughness, absorption, dispersion, radiance.
 *
 * <p>The constructors throw {@link enlightenment.math.InvalidValueException}, with the key of the scene format, for a value out
 * of range, and {@link NullPointerException} for a missing one. A colour may not reflect more than it receives: no linear component
 * is above 1.
 */
public sealed interface Material
        permits Material.Matte,
                Material.Mirror,
                Material.Glossy,
                Material.Coated,
                Material.Glass,
                Material.Scattering,
                Material.Fluorescent,
                Principled,
                Mix,
                Mask,
                NormalMap,
                Bump {

    /** The surface's colour; for a mirror or glass, the filter that is multiplied onto what is seen in or through it. */
    Texture color();

    /** Whether shadows show on the surface (false is the paper's {@code noShadow}, which physical shading does not have). */
    default boolean receivesShadows() {
        return true;
    }

    /**
     * The radiance with which the surface glows by itself, on the sides that its {@link #pattern} names, in physical shading: the object is a light then.
     * Black for glass and media: only what is opaque glows.
     */
    default Rgb radiance() {
        return Rgb.BLACK;
    }

    /**
     * The radiance with which it glows in the near ultraviolet (300 to 400 nm), in the unit of {@link #radiance}, on the sides
     * that its {@link #pattern} names. Only fluorescent surfaces show it.
     */
    default double ultraviolet() {
        return 0;
    }

    /**
     * The points and sides of the surface that emit {@link #radiance} and {@link #ultraviolet}, and by which factors: evenly and to both sides, unless
     * the kind of material has something else.
     */
    default EmissionPattern pattern() {
        return EmissionPattern.EVEN;
    }

    /** The {@link EmissionPattern#map} of its pattern. */
    default Optional<Texture> radianceMap() {
        return pattern().map();
    }

    /** The textures that it has besides its colour. */
    default List<Texture> textures() {
        return List.of();
    }

    /** The materials that it is made of, if it is made of others. */
    default List<Material> parts() {
        return List.of();
    }

    /** The name of this kind of material in the scene format, such as {@code "matte"}. */
    String type();

    /** Whether classic shading knows this kind of material; all others are for physical shading alone. */
    boolean isForClassicShading();

    /**
     * A diffuse surface; in classic shading, shaded by the cosine rule.
     *
     * @param color its colour: in physical shading its reflectance
     * @param receivesShadows whether shadows show on it
     * @param roughness of its microscopic surface, 0 (Lambert) to 1 (Portsmouth, Kutz and Hill, "EON: a practical
     *     energy-preserving rough diffuse BRDF", 2025)
     * @param radiance see {@link Material#radiance}
     * @param ultraviolet see {@link Material#ultraviolet}
     * @param pattern see {@link Material#pattern}
     */
    record Matte(
            Texture color,
            boolean receivesShadows,
            double roughness,
            Rgb radiance,
            double ultraviolet,
            EmissionPattern pattern)
            implements Material {
        /** Validates the components, as {@link Material} states. */
        public Matte {
            Reflectance.check(color);
            Check.range("roughness", roughness, 0, 1);
            Radiance.check("radiance", radiance);
            Radiance.check("ultraviolet", ultraviolet);
            Detail.checkRadiance(radiance, ultraviolet, pattern);
        }

        /** A surface whose points glow alike, if at all. */
        public Matte(Texture color, boolean receivesShadows, double roughness, Rgb radiance, double ultraviolet) {
            this(color, receivesShadows, roughness, radiance, ultraviolet, EmissionPattern.EVEN);
        }

        /** A surface that glows, if at all, in visible light alone. */
        public Matte(Texture color, boolean receivesShadows, double roughness, Rgb radiance) {
            this(color, receivesShadows, roughness, radiance, 0);
        }

        /** A Lambertian surface that does not glow. */
        public Matte(Texture color, boolean receivesShadows) {
            this(color, receivesShadows, 0, Rgb.BLACK);
        }

        /** A Lambertian surface that receives shadows and does not glow. */
        public static Matte of(Texture color) {
            return new Matte(color, true);
        }

        /** The same surface with another roughness. */
        public Matte withRoughness(double value) {
            return new Matte(color, receivesShadows, value, radiance, ultraviolet, pattern);
        }

        /** The same surface with another radiance. */
        public Matte withRadiance(Rgb value) {
            return new Matte(color, receivesShadows, roughness, value, ultraviolet, pattern);
        }

        /** This surface, whose radiance is emitted by other points or to other sides. */
        public Matte withPattern(EmissionPattern value) {
            return new Matte(color, receivesShadows, roughness, radiance, ultraviolet, value);
        }

        /** This surface, whose radiance is multiplied by a texture. */
        public Matte withRadianceMap(Texture value) {
            return new Matte(color, receivesShadows, roughness, radiance, ultraviolet, pattern.withMap(value));
        }

        @Override
        public List<Texture> textures() {
            return radianceMap().stream().toList();
        }

        @Override
        public String type() {
            return "matte";
        }

        @Override
        public boolean isForClassicShading() {
            return true;
        }
    }

    /**
     * A perfect mirror.
     *
     * @param color what is multiplied onto the reflected colour
     * @param receivesShadows has no effect: a mirror shows no shadows of its own
     * @param radiance see {@link Material#radiance}
     * @param ultraviolet see {@link Material#ultraviolet}
     * @param pattern see {@link Material#pattern}
     */
    record Mirror(Texture color, boolean receivesShadows, Rgb radiance, double ultraviolet, EmissionPattern pattern)
            implements Material {
        /** Validates the components, as {@link Material} states. */
        public Mirror {
            Reflectance.check(color);
            Radiance.check("radiance", radiance);
            Radiance.check("ultraviolet", ultraviolet);
            Detail.checkRadiance(radiance, ultraviolet, pattern);
        }

        /** A mirror whose points glow alike, if at all. */
        public Mirror(Texture color, boolean receivesShadows, Rgb radiance, double ultraviolet) {
            this(color, receivesShadows, radiance, ultraviolet, EmissionPattern.EVEN);
        }

        @Override
        public List<Texture> textures() {
            return radianceMap().stream().toList();
        }

        /** A mirror that glows, if at all, in visible light alone. */
        public Mirror(Texture color, boolean receivesShadows, Rgb radiance) {
            this(color, receivesShadows, radiance, 0);
        }

        /** A mirror that does not glow. */
        public Mirror(Texture color, boolean receivesShadows) {
            this(color, receivesShadows, Rgb.BLACK);
        }

        /** A mirror of this filter colour. */
        public static Mirror of(Texture color) {
            return new Mirror(color, true);
        }

        @Override
        public String type() {
            return "mirror";
        }

        @Override
        public boolean isForClassicShading() {
            return true;
        }
    }

    /**
     * A rough mirror, such as a metal: microscopic facets by the distribution GGX (Walter and others, 2007). Only physical shading
     * has it.
     *
     * @param color its reflectance where it is looked at and lit straight on (Schlick's Fresnel term leads from there to white at
     *     grazing angles); of a conductor, what is multiplied onto the exact Fresnel term
     * @param roughness 0 (a mirror) to 1; the parameter alpha of the distribution is its square
     * @param conductor the optical constants; empty for Schlick's term
     * @param multipleScattering whether light that meets several facets is counted; without it, rough surfaces are too dark
     * @param radiance see {@link Material#radiance}
     * @param ultraviolet see {@link Material#ultraviolet}
     * @param pattern see {@link Material#pattern}
     */
    record Glossy(
            Texture color,
            Amount roughness,
            Optional<Conductor> conductor,
            boolean multipleScattering,
            Rgb radiance,
            double ultraviolet,
            EmissionPattern pattern)
            implements Material {
        /** Validates the components, as {@link Material} states. */
        public Glossy {
            Reflectance.check(color);
            Objects.requireNonNull(roughness, "roughness");
            Objects.requireNonNull(conductor, "conductor");
            Radiance.check("radiance", radiance);
            Radiance.check("ultraviolet", ultraviolet);
            Detail.checkRadiance(radiance, ultraviolet, pattern);
        }

        /** A surface whose points glow alike, if at all. */
        public Glossy(
                Texture color,
                Amount roughness,
                Optional<Conductor> conductor,
                boolean multipleScattering,
                Rgb radiance,
                double ultraviolet) {
            this(color, roughness, conductor, multipleScattering, radiance, ultraviolet, EmissionPattern.EVEN);
        }

        /** A surface of the same roughness everywhere. */
        public Glossy(
                Texture color,
                double roughness,
                Optional<Conductor> conductor,
                boolean multipleScattering,
                Rgb radiance,
                double ultraviolet) {
            this(color, Detail.amount("roughness", roughness), conductor, multipleScattering, radiance, ultraviolet);
        }

        /** A surface that glows, if at all, in visible light alone. */
        public Glossy(
                Texture color,
                double roughness,
                Optional<Conductor> conductor,
                boolean multipleScattering,
                Rgb radiance) {
            this(color, roughness, conductor, multipleScattering, radiance, 0);
        }

        /** This surface with another roughness. */
        public Glossy withRoughness(Amount value) {
            return new Glossy(color, value, conductor, multipleScattering, radiance, ultraviolet, pattern);
        }

        @Override
        public List<Texture> textures() {
            return Detail.textures(roughness.textures(), radianceMap());
        }

        /** A surface with Schlick's Fresnel term and multiple scattering that does not glow. */
        public static Glossy of(Texture color, double roughness) {
            return new Glossy(color, roughness, Optional.empty(), true, Rgb.BLACK);
        }

        /** A metal of these optical constants and this filter colour, with multiple scattering. */
        public static Glossy metal(Texture color, Conductor conductor, double roughness) {
            return new Glossy(color, roughness, Optional.of(conductor), true, Rgb.BLACK);
        }

        @Override
        public String type() {
            return "glossy";
        }

        @Override
        public boolean isForClassicShading() {
            return false;
        }
    }

    /**
     * A matte surface under a dielectric coat, such as plastic, varnished wood or glazed clay: the coat reflects by Fresnel's equations, and what
     * enters it is reflected by the base. Only physical shading has it.
     *
     * @param color the reflectance of the base
     * @param roughness of the coat, 0 (smooth) to 1; the parameter alpha of the distribution GGX is its square
     * @param indexOfRefraction of the coat, relative to the surrounding medium: 1 (as without a coat) to {@value #LARGEST_INDEX}
     * @param nonlinear whether light that goes to and fro between coat and base is coloured by the base each time, which saturates its colour
     * @param radiance see {@link Material#radiance}
     * @param ultraviolet see {@link Material#ultraviolet}
     * @param pattern see {@link Material#pattern}
     */
    record Coated(
            Texture color,
            Amount roughness,
            double indexOfRefraction,
            boolean nonlinear,
            Rgb radiance,
            double ultraviolet,
            EmissionPattern pattern)
            implements Material {
        /** The index of refraction unless another one is given: that of most plastics and varnishes. */
        public static final double USUAL_INDEX = 1.5;

        /** The largest index of refraction: no transparent matter has more. */
        public static final double LARGEST_INDEX = 10;

        /** Validates the components, as {@link Material} states. */
        public Coated {
            Reflectance.check(color);
            Objects.requireNonNull(roughness, "roughness");
            Check.range("indexOfRefraction", indexOfRefraction, 1, LARGEST_INDEX);
            Radiance.check("radiance", radiance);
            Radiance.check("ultraviolet", ultraviolet);
            Detail.checkRadiance(radiance, ultraviolet, pattern);
        }

        /** A surface whose points glow alike, if at all. */
        public Coated(
                Texture color,
                Amount roughness,
                double indexOfRefraction,
                boolean nonlinear,
                Rgb radiance,
                double ultraviolet) {
            this(color, roughness, indexOfRefraction, nonlinear, radiance, ultraviolet, EmissionPattern.EVEN);
        }

        /** A surface whose coat has the same roughness everywhere. */
        public Coated(
                Texture color,
                double roughness,
                double indexOfRefraction,
                boolean nonlinear,
                Rgb radiance,
                double ultraviolet) {
            this(color, Detail.amount("roughness", roughness), indexOfRefraction, nonlinear, radiance, ultraviolet);
        }

        /** This surface, whose coat has another roughness. */
        public Coated withRoughness(Amount value) {
            return new Coated(color, value, indexOfRefraction, nonlinear, radiance, ultraviolet, pattern);
        }

        @Override
        public List<Texture> textures() {
            return Detail.textures(roughness.textures(), radianceMap());
        }

        /** A surface of this colour with a coat of index 1.5 that does not glow. */
        public static Coated of(Texture color, double roughness) {
            return new Coated(color, roughness, USUAL_INDEX, false, Rgb.BLACK, 0);
        }

        @Override
        public String type() {
            return "coated";
        }

        @Override
        public boolean isForClassicShading() {
            return false;
        }
    }

    /**
     * Glass: light is refracted by Snell's law, or totally reflected; in physical shading Fresnel's equations say how much is
     * reflected.
     *
     * @param color multiplied onto what is seen through the surface, each time a ray crosses it; not onto what it reflects
     * @param indexOfRefraction relative to the surrounding medium (1), greater than 0
     * @param transparency the share of what is seen that comes through: 0 (a matte surface) to 1 (clear)
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
     */
    record Glass(
            Texture color,
            double indexOfRefraction,
            double transparency,
            int priority,
            boolean receivesShadows,
            double roughness,
            Rgb absorption,
            boolean multipleScattering,
            OptionalDouble dispersion,
            boolean smoothRefraction)
            implements Material {
        /** Validates the components, as {@link Material} states. */
        public Glass {
            Reflectance.check(color);
            Check.positive("indexOfRefraction", indexOfRefraction);
            Check.range("transparency", transparency, 0, 1);
            Check.range("roughness", roughness, 0, 1);
            Objects.requireNonNull(absorption, "absorption");
            if (dispersion.isPresent()) {
                checkDispersion(indexOfRefraction, dispersion.getAsDouble());
            }
            Check.that(
                    !smoothRefraction || roughness == 0,
                    "smoothRefraction",
                    "must stand without \"roughness\": rough glass refracts by the normals of its triangles");
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

        /** Glass that refracts by the surface's own normals. */
        public Glass(
                Texture color,
                double indexOfRefraction,
                double transparency,
                int priority,
                boolean receivesShadows,
                double roughness,
                Rgb absorption,
                boolean multipleScattering,
                OptionalDouble dispersion) {
            this(
                    color,
                    indexOfRefraction,
                    transparency,
                    priority,
                    receivesShadows,
                    roughness,
                    absorption,
                    multipleScattering,
                    dispersion,
                    false);
        }

        /** Glass that refracts all wavelengths alike. */
        public Glass(
                Texture color,
                double indexOfRefraction,
                double transparency,
                int priority,
                boolean receivesShadows,
                double roughness,
                Rgb absorption,
                boolean multipleScattering) {
            this(
                    color,
                    indexOfRefraction,
                    transparency,
                    priority,
                    receivesShadows,
                    roughness,
                    absorption,
                    multipleScattering,
                    OptionalDouble.empty());
        }

        /** Smooth glass that absorbs nothing. */
        public Glass(
                Texture color, double indexOfRefraction, double transparency, int priority, boolean receivesShadows) {
            this(color, indexOfRefraction, transparency, priority, receivesShadows, 0, Rgb.BLACK, true);
        }

        /** Clear, smooth glass of this filter colour and index of refraction, priority 0. */
        public static Glass of(Texture color, double indexOfRefraction) {
            return new Glass(color, indexOfRefraction, 1, 0, true);
        }

        /** The same glass with another roughness. */
        public Glass withRoughness(double value) {
            return with(value, absorption, dispersion, smoothRefraction);
        }

        /** The same glass that absorbs this per scene unit. */
        public Glass withAbsorption(Rgb value) {
            return with(roughness, value, dispersion, smoothRefraction);
        }

        /** The same glass with this Abbe number. */
        public Glass withDispersion(double value) {
            return with(roughness, absorption, OptionalDouble.of(value), smoothRefraction);
        }

        /** This glass with another {@link #smoothRefraction()}; needs roughness 0 if true. */
        public Glass withSmoothRefraction(boolean value) {
            return with(roughness, absorption, dispersion, value);
        }

        private Glass with(double rough, Rgb absorbed, OptionalDouble abbe, boolean smoothly) {
            return new Glass(
                    color,
                    indexOfRefraction,
                    transparency,
                    priority,
                    receivesShadows,
                    rough,
                    absorbed,
                    multipleScattering,
                    abbe,
                    smoothly);
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

    /**
     * A solid that light enters and is scattered in, such as wax, milk, marble or skin. Only physical shading has it.
     *
     * @param medium what is inside
     * @param indexOfRefraction of the medium, greater than 0; with 1 there is no border that reflects or turns light
     * @param roughness of the border, 0 (smooth) to 1; the parameter alpha of the distribution GGX is its square
     * @param priority as that of {@link Glass}
     */
    record Scattering(Medium medium, double indexOfRefraction, double roughness, int priority) implements Material {
        private static final Texture WHITE = Texture.of(Rgb.WHITE);

        /** Validates the components, as {@link Material} states. */
        public Scattering {
            Objects.requireNonNull(medium, "medium");
            Check.positive("indexOfRefraction", indexOfRefraction);
            Check.range("roughness", roughness, 0, 1);
        }

        /** A medium without a border that reflects, priority 0. */
        public static Scattering of(Medium medium) {
            return new Scattering(medium, 1, 0, 0);
        }

        /** White: what passes the border is not filtered. What colour it seems to have is a matter of its medium. */
        @Override
        public Texture color() {
            return WHITE;
        }

        @Override
        public String type() {
            return "scattering";
        }

        @Override
        public boolean isForClassicShading() {
            return false;
        }
    }

    /**
     * A Lambertian surface with a dye that takes in light of one band of wavelengths and gives some of it back in another, longer
     * ones. Only physical shading has it.
     *
     * @param color its reflectance: what is given back unchanged
     * @param absorption the wavelengths that the dye absorbs of what is not reflected
     * @param emission the wavelengths that it emits; never shorter ones than it took in (Stokes)
     * @param yield the photons that it emits for each that it absorbs, 0..1
     * @param radiance see {@link Material#radiance}
     * @param ultraviolet see {@link Material#ultraviolet}
     * @param pattern see {@link Material#pattern}
     */
    record Fluorescent(
            Texture color,
            WavelengthBand absorption,
            WavelengthBand emission,
            double yield,
            Rgb radiance,
            double ultraviolet,
            EmissionPattern pattern)
            implements Material {
        /** Validates the components, as {@link Material} states. */
        public Fluorescent {
            Reflectance.check(color);
            Objects.requireNonNull(absorption, "absorption");
            Objects.requireNonNull(emission, "emission");
            Check.that(
                    emission.high() > absorption.low(),
                    "emission",
                    "must reach beyond the shortest wavelength of \"absorption\": what is emitted is never shorter than"
                            + " what was absorbed");
            Check.range("yield", yield, 0, 1);
            Radiance.check("radiance", radiance);
            Radiance.check("ultraviolet", ultraviolet);
            Detail.checkRadiance(radiance, ultraviolet, pattern);
        }

        /** A surface whose points glow alike, if at all. */
        public Fluorescent(
                Texture color,
                WavelengthBand absorption,
                WavelengthBand emission,
                double yield,
                Rgb radiance,
                double ultraviolet) {
            this(color, absorption, emission, yield, radiance, ultraviolet, EmissionPattern.EVEN);
        }

        @Override
        public List<Texture> textures() {
            return radianceMap().stream().toList();
        }

        /** A surface that does not glow by itself. */
        public Fluorescent(Texture color, WavelengthBand absorption, WavelengthBand emission, double yield) {
            this(color, absorption, emission, yield, Rgb.BLACK, 0);
        }

        @Override
        public String type() {
            return "fluorescent";
        }

        @Override
        public boolean isForClassicShading() {
            return false;
        }
    }
}
