package enlightenment.scene;

import enlightenment.camera.Camera;
import enlightenment.geometry.Mesh;
import enlightenment.geometry.Rectangle;
import enlightenment.geometry.Shape;
import enlightenment.geometry.Sphere;
import enlightenment.geometry.Triangle;
import enlightenment.light.Light;
import enlightenment.material.Composite;
import enlightenment.material.Glass;
import enlightenment.material.Material;
import enlightenment.math.InvalidValueException;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Objects;
import java.util.function.Predicate;
import java.util.stream.Collectors;

/** Finds the camera and the materials of objects that have no meaning in a scene's shading; materials that nothing uses do no harm. */
final class ShadingFit {
    /** How many further places a message names. */
    private static final int MOST = 3;

    private static final String SOLIDS = "; give it thickness, as a \"box\" has it, or close its ends";

    private final Shading.Model model;

    /** Whether a medium fills the whole scene. */
    private final boolean hasMedium;

    private final Map<String, Material> named;

    /** The problems by their places. */
    private final Map<String, String> found = new LinkedHashMap<>();

    /** The place of the first glass that disperses light; null if there is none. */
    private String glass;

    /** The place of the first fluorescent surface; null if there is none. */
    private String dye;

    ShadingFit(Shading shading, Map<String, Material> named) {
        this.model = shading.model();
        hasMedium = shading instanceof Shading.Physical p && p.medium().isPresent();
        this.named = named;
    }

    /**
     * Fails if a camera has no meaning in this shading.
     *
     * @throws InvalidValueException with the place
     */
    void require(Camera camera) {
        boolean hasLens = camera instanceof Camera.Perspective p && p.lens().isPresent();
        if (model == Shading.Model.CLASSIC && hasLens) {
            throw new InvalidValueException(
                    "camera/lens",
                    "needs \"shading\": {\"model\": \"physical\"}; in classic shading all rays come from one point");
        }
        if (model == Shading.Model.PHYSICAL
                && camera instanceof Camera.Window w
                && w.pupilRadius() / Camera.Lens.MOST_DISTANCES > w.distance()) {
            throw new InvalidValueException(
                    "camera/pupilRadius",
                    "must be at most " + Camera.Lens.MOST_DISTANCES
                            + " times the distance between \"eye\" and window in"
                            + " physical shading, where it is a lens; not " + w.pupilRadius());
        }
        if (hasMedium && camera instanceof Camera.Isometric) {
            throw new InvalidValueException(
                    "camera/type",
                    "must not be \"isometric\" in a scene that a \"medium\" fills: this view is from infinitely far, from"
                            + " where nothing is seen through it; \"orthographic\" has an eye");
        }
    }

    /**
     * Fails if a light has no meaning in this shading.
     *
     * @throws InvalidValueException with the place
     */
    void require(Light light, int index) {
        if (model == Shading.Model.CLASSIC && !light.isForClassicShading()) {
            throw new InvalidValueException(
                    "lights/" + index + "/type",
                    "\"" + light.type() + "\" needs \"shading\": {\"model\": \"physical\"}; classic shading has"
                            + " \"sphere\", \"rectangle\" and \"point\"");
        }
    }

    /** Checks an object. */
    void look(SceneObject object, int index) {
        String place = "objects/" + index + "/material";
        look(object.material(), place);
        if (model == Shading.Model.PHYSICAL) {
            lookAtPane(object, place);
            lookAtRelief(object, place);
        }
        for (int i = 0; i < object.faces().size(); i++) {
            look(object.faces().get(i), "objects/" + index + "/faces/" + i);
        }
    }

    /** Normals turn about the directions of a texture, which are known of some shapes. */
    private void lookAtRelief(SceneObject object, String place) {
        Shape shape = object.shape();
        if (shape instanceof Mesh
                || shape instanceof Rectangle
                || shape instanceof Triangle
                || shape instanceof Sphere) {
            return;
        }
        if (object.faces().isEmpty()) {
            lookAtRelief(object.material(), shape, place);
        }
        for (int i = 0; i < object.faces().size(); i++) {
            lookAtRelief(object.faces().get(i), shape, place.replace("material", "faces/" + i));
        }
    }

    private void lookAtRelief(Material material, Shape shape, String place) {
        if (material instanceof Composite.NormalMap || material instanceof Composite.Bump) {
            found.putIfAbsent(
                    place,
                    "normal maps and bumps need a mesh, a rectangle, a triangle or a sphere: the directions of textures are"
                            + " not known of a " + shape.type());
        }
        material.parts().forEach(part -> lookAtRelief(part, shape, place));
    }

    /** What has no thickness has no medium inside, and no second face that could turn light back. */
    private void lookAtPane(SceneObject object, String place) {
        Material material = object.material();
        if (material instanceof Material.Scattering && !object.shape().enclosesVolume()) {
            found.putIfAbsent(place, "\"scattering\" fills a solid, and this shape encloses no volume" + SOLIDS);
        } else if (material instanceof Glass glass
                && !glass.roughness().isZero()
                && !object.shape().enclosesVolume()) {
            found.putIfAbsent(
                    place, "glass with \"roughness\" needs two faces, and this shape encloses no volume" + SOLIDS);
        }
    }

    private void look(Material material, String place) {
        Shading.LightFeature feature = model == Shading.Model.PHYSICAL ? Shading.LightFeature.of(material) : null;
        if (feature == Shading.LightFeature.DISPERSION && glass == null) {
            glass = placeOf(named, material, place);
        } else if (feature == Shading.LightFeature.FLUORESCENCE && dye == null) {
            dye = placeOf(named, material, place);
        }
        if (model == Shading.Model.CLASSIC && !material.isForClassicShading()) {
            found.putIfAbsent(
                    placeOf(named, material, place) + "/type",
                    "\"" + material.type() + "\" needs \"shading\": {\"model\": \"physical\"}; classic shading has"
                            + " \"matte\", \"mirror\" and \"glass\"");
        } else if (model == Shading.Model.PHYSICAL && !material.receivesShadows()) {
            found.putIfAbsent(
                    placeOf(named, material, place) + "/receivesShadows",
                    "must be true in physical shading: what stands in the way of light takes it from every surface alike");
        }
        if (model == Shading.Model.PHYSICAL) {
            lookAtParts(material, place);
        }
    }

    private void lookAtParts(Material material, String place) {
        for (int i = 0; i < material.parts().size(); i++) {
            String key =
                    material instanceof Glass ? "/opaque" : material.parts().size() == 1 ? "/of" : "/materials/" + i;
            look(material.parts().get(i), placeOf(named, material, place) + key);
        }
    }

    /** The place of a material: its name, if it has one. */
    static String placeOf(Map<String, Material> named, Material material, String place) {
        String name = nameOf(m -> m == material, named);
        String known = name == null ? nameOf(m -> Objects.equals(m, material), named) : name;
        return known == null ? place : "materials/" + SceneException.escaped(known);
    }

    private static String nameOf(Predicate<Material> isMeant, Map<String, Material> named) {
        for (Map.Entry<String, Material> entry : named.entrySet()) {
            if (isMeant.test(entry.getValue())) {
                return entry.getKey();
            }
        }
        return null;
    }

    /**
     * Fails if the objects ask for what cannot be had together.
     *
     * @throws InvalidValueException at the place of the glass; its text names the other one
     */
    void requireTogether() {
        if (glass != null && dye != null) {
            throw new InvalidValueException(
                    glass + "/dispersion",
                    "cannot stand together with a fluorescent surface (/" + dye
                            + "): dispersion follows single wavelengths,"
                            + " fluorescence bands of them; leave one of the two out");
        }
    }

    /**
     * Fails if anything was found.
     *
     * @throws InvalidValueException at the first place; its text names the others
     */
    void throwIfAny() {
        if (found.isEmpty()) {
            return;
        }
        Map.Entry<String, String> first = found.entrySet().iterator().next();
        found.remove(first.getKey());
        String others = found.isEmpty()
                ? ""
                : "; the same at "
                        + found.keySet().stream().limit(MOST).map(p -> "/" + p).collect(Collectors.joining(", "))
                        + (found.size() > MOST ? " and " + (found.size() - MOST) + " more" : "");
        throw new InvalidValueException(first.getKey(), first.getValue() + others);
    }
}
