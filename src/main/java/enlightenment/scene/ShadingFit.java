package enlightenment.scene;

import enlightenment.camera.Camera;
import enlightenment.material.Material;
import enlightenment.math.InvalidValueException;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Objects;
import java.util.stream.Collectors;

/** Finds the camera and the materials of objects that have no meaning in a scene's shading; materials that nothing uses do no harm. */
final class ShadingFit {
    /** How many further places are told. */
    private static final int MOST = 3;

    private final Shading.Model model;
    private final Map<String, Material> named;

    /** What is wrong, by its place. */
    private final Map<String, String> found = new LinkedHashMap<>();

    ShadingFit(Shading shading, Map<String, Material> named) {
        this.model = shading.model();
        this.named = named;
    }

    /**
     * Fails if a camera has no meaning in this shading.
     *
     * @throws InvalidValueException with the place
     */
    void require(Camera camera) {
        if (model == Shading.Model.PHYSICAL && camera instanceof Camera.Window w && w.pupilRadius() > 0) {
            throw new InvalidValueException(
                    "camera/pupilRadius",
                    "must be 0 in physical shading: a lens is not modelled, and all light comes to the eye in one point;"
                            + " leave it out");
        }
    }

    /** Looks at an object. */
    void look(SceneObject object, int index) {
        look(object.material(), "objects/" + index + "/material");
        for (int i = 0; i < object.faces().size(); i++) {
            look(object.faces().get(i), "objects/" + index + "/faces/" + i);
        }
    }

    private void look(Material material, String place) {
        if (model == Shading.Model.CLASSIC && material instanceof Material.Glossy) {
            found.putIfAbsent(
                    placeOf(material, place) + "/type",
                    "\"glossy\" needs \"shading\": {\"model\": \"physical\"}; classic shading has \"matte\", \"mirror\" and"
                            + " \"glass\"");
        } else if (model == Shading.Model.PHYSICAL && !material.receivesShadows()) {
            found.putIfAbsent(
                    placeOf(material, place) + "/receivesShadows",
                    "must be true in physical shading: what stands in the way of light takes it from every surface alike");
        }
    }

    /** Where a material stands: with its name, if it has one. */
    private String placeOf(Material material, String place) {
        for (Map.Entry<String, Material> entry : named.entrySet()) {
            if (Objects.equals(entry.getValue(), material)) {
                return "materials/" + entry.getKey().replace("~", "~0").replace("/", "~1");
            }
        }
        return place;
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
