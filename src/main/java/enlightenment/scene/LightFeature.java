package enlightenment.scene;

import enlightenment.light.Light;
import enlightenment.material.Glass;
import enlightenment.material.Material;
import java.util.EnumMap;
import java.util.Map;

/**
 * What light may do in physical shading that not every method can follow. A scene asks for it by what its objects are made of, or by its
 * shading; what it does not ask for costs nothing.
 */
public enum LightFeature {
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
        if (!(scene.shading() instanceof PhysicalShading shading)) {
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
