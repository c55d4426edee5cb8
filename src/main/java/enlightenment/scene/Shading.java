package enlightenment.scene;

import enlightenment.check.Check;
import enlightenment.color.DisplayRgb;
import enlightenment.color.Rgb;
import enlightenment.light.Light;
import enlightenment.material.Glass;
import enlightenment.material.Material;
import enlightenment.material.Medium;
import java.util.Collection;
import java.util.EnumMap;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.stream.Collectors;

/** How surfaces are shaded: what one camera sample is worth. Which methods can render it is a matter of {@link Method#shadings}. */
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

        /** Of any shading: things that move while the shutter is open. */
        MOTION("what moves while the shutter is open");

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
}
