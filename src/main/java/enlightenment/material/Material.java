package enlightenment.material;

import enlightenment.check.Check;
import enlightenment.check.Radiance;
import enlightenment.color.Rgb;
import java.util.List;
import java.util.Objects;
import java.util.Optional;

/**
 * What a surface does with light, such as matte paint, glass or a metal: an immutable description. Classic shading ignores what only physical
 * shading knows of a material: roughness, absorption, dispersion, radiance.
 *
 * <p>The constructors throw {@link enlightenment.math.InvalidValueException}, with the key of the scene format, for a value out
 * of range, and {@link NullPointerException} for a missing one. A colour may not reflect more than it receives: no linear component
 * is above 1.
 *
 */
public sealed interface Material
        permits Material.Matte,
                Material.Mirror,
                Glossy,
                Coated,
                Glass,
                Material.Scattering,
                Material.Fluorescent,
                Principled,
                Composite {
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
            Radiance.check("radiance", radiance.max());
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

        /** This surface with another roughness. */
        public Matte withRoughness(double value) {
            return new Matte(color, receivesShadows, value, radiance, ultraviolet, pattern);
        }

        /** This surface with another radiance. */
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
            Radiance.check("radiance", radiance.max());
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
     * A solid that light enters and is scattered in, such as wax, milk, marble or skin. Only physical shading has it.
     *
     * @param medium what is inside
     * @param indexOfRefraction of the medium, greater than 0; with 1 there is no interface that reflects or turns light
     * @param roughness of the interface, 0 (smooth) to 1; the parameter alpha of the distribution GGX is its square
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

        /** A medium without an interface that reflects, priority 0. */
        public static Scattering of(Medium medium) {
            return new Scattering(medium, 1, 0, 0);
        }

        /** White: what passes the interface is not filtered. What colour it seems to have is a matter of its medium. */
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
            Radiance.check("radiance", radiance.max());
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

    /**
     * A band of wavelengths of light in air, in nanometres.
     *
     * @param low its shortest wavelength, at least {@link #SHORTEST}
     * @param high its longest wavelength, greater than {@code low} and at most {@link #LONGEST}
     */
    record WavelengthBand(double low, double high) {
        /** The shortest wavelength that is modelled: that of near ultraviolet light, in nanometres. */
        public static final double SHORTEST = 300;

        /** The longest wavelength that is modelled: that of the deepest red which is seen, in nanometres. */
        public static final double LONGEST = 780;

        /** @throws enlightenment.math.InvalidValueException if the band is empty or not within the modelled wavelengths */
        public WavelengthBand {
            Check.that(
                    low >= SHORTEST && low < high && high <= LONGEST,
                    "band",
                    "must be two growing wavelengths [from, to] in 300..780 nm, not [" + low + ", " + high + "]");
        }
    }

    /**
     * How what a surface emits depends on the point and on the side of the surface. Immutable.
     *
     * @param map the factor, by band and in linear light, that {@link Material#radiance} is multiplied by at each point of the surface; that
     *     of {@link Material#ultraviolet} is the blue one. Empty if all points emit alike
     * @param side the sides that emit
     */
    record EmissionPattern(Optional<Texture> map, Side side) {
        /** All points emit alike, to both sides. */
        public static final EmissionPattern EVEN = new EmissionPattern(Optional.empty(), Side.BOTH);

        /** The sides of a surface that emit. */
        public enum Side {
            /** Both sides. */
            BOTH,

            /**
             * The front alone: the side that the geometric normal points to. That is the outside of balls, boxes, cylinders, cones and tori; the side
             * that (upperLeft − lowerLeft) × (lowerRight − lowerLeft) of a rectangle points to, that a disk's normal points to, and, of a triangle with the
             * corners a, b, c, also in a mesh, the side that (b − a) × (c − a) points to once it is placed.
             */
            FRONT,

            /** The other side alone: the inside of balls, boxes, cylinders, cones and tori. */
            BACK
        }

        /** Both must be there. */
        public EmissionPattern {
            Objects.requireNonNull(map, "radianceMap");
            Objects.requireNonNull(side, "radianceSide");
        }

        /** Emission to both sides. */
        public static EmissionPattern of(Optional<Texture> map) {
            return new EmissionPattern(map, Side.BOTH);
        }

        /** This pattern with another factor. */
        public EmissionPattern withMap(Texture value) {
            return new EmissionPattern(Optional.of(value), side);
        }

        /** This pattern on other sides. */
        public EmissionPattern withSide(Side value) {
            return new EmissionPattern(map, value);
        }
    }
}
