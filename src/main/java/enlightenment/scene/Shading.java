package enlightenment.scene;

import enlightenment.check.Check;
import enlightenment.check.Radiance;
import enlightenment.color.DisplayRgb;
import enlightenment.color.Rgb;
import enlightenment.light.Light;
import enlightenment.material.Glass;
import enlightenment.material.Material;
import enlightenment.material.Medium;
import enlightenment.material.Texture;
import java.util.Collection;
import java.util.EnumMap;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.stream.Collectors;

/**
 * How the light of a camera ray is computed: by the paper's cosine shading, or by the rendering equation. Which methods can render it is a matter
 * of {@link Method#shadings}.
 */
public sealed interface Shading permits Shading.Classic, Shading.Physical {
    /** The kinds of shading. */
    enum Model {
        /** {@link Classic}. */
        CLASSIC,

        /** {@link Physical}. */
        PHYSICAL;

        /** The name in scene files. */
        public String word() {
            return name().toLowerCase(Locale.ROOT);
        }

        /** The names of some, in order, with "and" between them. */
        static String words(Collection<Model> models) {
            return models.stream().sorted().map(Model::word).collect(Collectors.joining(" and "));
        }
    }

    /** Which kind it is. */
    Model model();

    /**
     * The paper's cosine shading: with c the surface colour, cosθ the cosine between normal and direction to a light point
     * and k = {@code shadow}, colour = c · light · (ambient + (1 − ambient) · mean of (visible ? 1 : k) · cosθ).
     *
     * @param ambient the share of light that comes from everywhere, 0..1
     * @param shadow how much of the direct light an occluded point keeps, 0..1; 0.5 in the paper
     * @param background what is seen where nothing is
     * @param maxBounces how often a path may be reflected or refracted, 0..1,000,000; beyond that it sees black
     */
    record Classic(double ambient, double shadow, DisplayRgb background, int maxBounces) implements Shading {
        /** The greatest limit on mirrors and glass surfaces that a path may follow. */
        public static final int MAX_BOUNCES = 1_000_000;

        /** The paper's settings: ambient 0.5, shadow 0.5, black background. */
        public static final Classic DEFAULT = new Classic(0.5, 0.5, DisplayRgb.BLACK, 100);

        public Classic {
            Check.range("ambient", ambient, 0, 1);
            Check.range("shadow", shadow, 0, 1);
            Objects.requireNonNull(background, "background");
            Check.that(
                    maxBounces >= 0 && maxBounces <= MAX_BOUNCES,
                    "maxBounces",
                    "must be a whole number in 0.." + MAX_BOUNCES + ", not " + maxBounces);
        }

        @Override
        public Model model() {
            return Model.CLASSIC;
        }
    }

    /**
     * Shading by the rendering equation: all light comes from lights, glowing surfaces and the background, on any number of paths.
     *
     * @param maxBounces the most scattering events of a path, 0..1,000,000: with 0 only what glows is seen, with 1 light that was
     *     scattered once; media count. Empty: nothing but chance ends a path, so that no light is left out
     * @param background the light that comes from everywhere that nothing hides
     * @param medium what fills the whole scene outside of its solids, such as fog; its index of refraction is 1. Empty: nothing does
     */
    record Physical(OptionalInt maxBounces, Background background, Optional<Medium> medium) implements Shading {
        /** The greatest limit on the scattering events of a path. */
        public static final int MAX_BOUNCES = Shading.Classic.MAX_BOUNCES;

        /** No limit, and a black background. */
        public static final Physical DEFAULT = new Physical(OptionalInt.empty(), Rgb.BLACK);

        /**
         * Checks the range.
         *
         * @throws enlightenment.math.InvalidValueException (key {@code maxBounces}) if the limit is out of it
         */
        public Physical {
            Objects.requireNonNull(background, "background");
            Objects.requireNonNull(medium, "medium");
            if (maxBounces.isPresent()) {
                int most = maxBounces.getAsInt();
                Check.that(
                        most >= 0 && most <= MAX_BOUNCES,
                        "maxBounces",
                        "must be a whole number in 0.." + MAX_BOUNCES + ", not " + most);
            }
        }

        /**
         * Shading in empty space with the same light from everywhere.
         *
         * @param background its radiance, linear; in the unit of lights
         * @throws enlightenment.math.InvalidValueException as the other constructor
         */
        public Physical(OptionalInt maxBounces, Rgb background) {
            this(maxBounces, new Background.Constant(background), Optional.empty());
        }

        @Override
        public Model model() {
            return Model.PHYSICAL;
        }
    }

    /**
     * What light may do in physical shading that not every method can follow. A scene asks for it by what its objects are made of, or by its
     * shading; what it does not ask for costs nothing.
     */
    enum LightFeature {
        /** Light that is scattered inside of solids, or of what fills the whole scene. */
        SCATTERING("media that scatter light"),

        /** Light that changes its wavelength at surfaces. */
        FLUORESCENCE("fluorescent surfaces"),

        /** Glass that refracts each wavelength in its own way. */
        DISPERSION("dispersion of glass"),

        /** Light from a picture or a sky around the scene, or from a distant light. */
        SURROUNDINGS("light from a picture, a sky or a distant light"),

        /** Of any shading: objects that move while the shutter is open. */
        MOTION("what moves while the shutter is open"),

        /** What moves while the shutter is open, in classic shading: asked for beside {@link #MOTION}. */
        CLASSIC_MOTION("what moves while the shutter is open in classic shading");

        private final String description;

        LightFeature(String description) {
            this.description = description;
        }

        /** What it is, for people: the rest of a sentence that begins with "cannot render". */
        public String description() {
            return description;
        }

        /**
         * What a scene asks for, in order, and where: the place (a JSON pointer) that says so, the first one of several. Materials that no
         * object is made of ask for nothing.
         */
        public static Map<LightFeature, String> of(Scene scene) {
            Map<LightFeature, String> asked = new EnumMap<>(LightFeature.class);
            if (!scene.instants().isEmpty()) {
                asked.put(MOTION, "/animation/shutter");
            }
            if (!(scene.shading() instanceof Shading.Physical shading)) {
                if (asked.containsKey(MOTION)) {
                    asked.put(CLASSIC_MOTION, "/animation/shutter");
                }
                return asked;
            }
            if (shading.medium().isPresent()) {
                asked.put(SCATTERING, "/shading/medium");
            }
            if (!(shading.background() instanceof Background.Constant)) {
                asked.put(SURROUNDINGS, "/shading/background");
            }
            for (int i = 0; i < scene.lights().size(); i++) {
                if (scene.lights().get(i) instanceof Light.Distant) {
                    asked.putIfAbsent(SURROUNDINGS, "/lights/" + i);
                }
            }
            // Neighbours mostly share their material.
            Material last = null;
            for (int i = 0; i < scene.objects().size(); i++) {
                SceneObject object = scene.objects().get(i);
                if (object.material() != last) {
                    last = object.material();
                    look(scene, last, "objects/" + i + "/material", asked);
                }
                for (int face = 0; face < object.faces().size(); face++) {
                    look(scene, object.faces().get(face), "objects/" + i + "/faces/" + face, asked);
                }
            }
            return asked;
        }

        private static void look(Scene scene, Material material, String place, Map<LightFeature, String> asked) {
            LightFeature feature = of(material);
            if (feature != null && !asked.containsKey(feature)) {
                String key = feature == DISPERSION ? "/dispersion" : "/type";
                asked.put(feature, "/" + ShadingFit.placeOf(scene.materials(), material, place) + key);
            }
        }

        /** What a material asks for; null if it is nothing. */
        static LightFeature of(Material material) {
            if (material instanceof Material.Scattering) {
                return SCATTERING;
            }
            if (material instanceof Material.Fluorescent) {
                return FLUORESCENCE;
            }
            boolean disperses = material instanceof Glass g
                    && g.dispersion().isPresent()
                    && g.transparency() > 0
                    && g.indexOfRefraction() != 1;
            return disperses ? DISPERSION : null;
        }
    }

    /**
     * The light that comes from everywhere that nothing hides, in physical shading: an immutable description. Up is +y; azimuths go
     * from +z, which is 0, over +x, which is 90°.
     *
     * <p>The constructors throw {@link enlightenment.math.InvalidValueException}, with the key of the scene format, for a value out
     * of range, and {@link NullPointerException} for a missing one.
     */
    sealed interface Background
            permits Shading.Background.Constant, Shading.Background.Picture, Shading.Background.Sky {

        /**
         * Constant radiance from all directions.
         *
         * @param radiance linear, in the unit of lights
         */
        record Constant(Rgb radiance) implements Background {
            /** No light. */
            public static final Constant BLACK = new Constant(Rgb.BLACK);

            /** Validates the components, as {@link Background} states. */
            public Constant {
                Radiance.check("radiance", radiance.max());
            }
        }

        /**
         * A picture of all directions, by longitude and latitude: its upper edge is straight up, its lower edge straight down, and
         * its middle column faces azimuth 0; azimuths grow to the right.
         *
         * @param picture the image file; its numbers become light as those of a surface's colour do
         * @param radiance the radiance of light 1 of the picture, for each band
         * @param rotation by how much the picture is turned about +y towards growing azimuths, in degrees
         */
        record Picture(Texture.File picture, Rgb radiance, double rotation) implements Background {
            /** Validates the components, as {@link Background} states. */
            public Picture {
                Objects.requireNonNull(picture, "picture");
                Radiance.check("radiance", radiance.max());
                Check.finite("rotation", rotation);
            }

            /** A picture as it is. */
            public static Picture of(Texture.File picture) {
                return new Picture(picture, Rgb.WHITE, 0);
            }
        }

        /**
         * A clear sky and the sun in it.
         *
         * @param elevation of the sun above the horizon, 0..90 degrees
         * @param azimuth of the sun, in degrees
         * @param turbidity how hazy the air is: {@link #LEAST_TURBIDITY} to {@link #GREATEST_TURBIDITY}; 2 is
         *     a very clear day, 3 a clear one, 6 a hazy one
         * @param groundAlbedo the share of light that the plain under the sky gives back, which is what is seen below the horizon: each
         *     band at most 1
         * @param radiance what the radiance of sky and sun is multiplied by, for each band
         * @param hasSun whether the sun's disk shines; without it there is the light of the sky alone
         */
        record Sky(double elevation, double azimuth, double turbidity, Rgb groundAlbedo, Rgb radiance, boolean hasSun)
                implements Background {
            /** Very clear air; the model makes no sense below. */
            public static final double LEAST_TURBIDITY = 2;

            /** Fog, almost. */
            public static final double GREATEST_TURBIDITY = 10;

            /** The turbidity of a sky that says none. */
            public static final double USUAL_TURBIDITY = 3;

            /** What the ground reflects under a sky that says nothing of it. */
            public static final Rgb USUAL_GROUND = Rgb.gray(0.2);

            /** Validates the components, as {@link Background} states. */
            public Sky {
                Check.range("elevation", elevation, 0, 90);
                Check.finite("azimuth", azimuth);
                Check.range("turbidity", turbidity, LEAST_TURBIDITY, GREATEST_TURBIDITY);
                Check.that(
                        groundAlbedo.max() <= 1,
                        "groundAlbedo",
                        "must lie in 0..1: ground does not give back more than it receives");
                Radiance.check("radiance", radiance.max());
            }

            /** The sky of a clear day, with its sun. */
            public static Sky of(double elevation, double azimuth) {
                return new Sky(elevation, azimuth, USUAL_TURBIDITY, USUAL_GROUND, Rgb.WHITE, true);
            }
        }
    }
}
