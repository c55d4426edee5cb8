package enlightenment.scene;

import enlightenment.check.Check;
import enlightenment.geometry.Cube;
import enlightenment.geometry.Shape;
import enlightenment.geometry.Transform;
import enlightenment.material.Material;
import java.util.List;
import java.util.Objects;

/**
 * An object of a scene: a shape and what it is made of.
 *
 * @param name its name, unique in the scene, or "" if it has none
 * @param shape its surface
 * @param material what it is made of
 * @param faces empty, or for a cube the materials of its six faces: -x, +x, -y, +y, -z, +z before rotation
 *
 */
public record SceneObject(String name, Shape shape, Material material, List<Material> faces) {
    /** @throws enlightenment.math.InvalidValueException if there are faces, but not six or not on a cube */
    public SceneObject {
        Objects.requireNonNull(name, "name");
        Objects.requireNonNull(shape, "shape");
        Objects.requireNonNull(material, "material");
        faces = List.copyOf(faces);
        Check.that(
                faces.isEmpty() || shape instanceof Cube && faces.size() == 6,
                "faces",
                "must be six materials, on a cube");
    }

    /** An object without a name, of one material. */
    public static SceneObject of(Shape shape, Material material) {
        return new SceneObject("", shape, material, List.of());
    }

    /**
     * This object after a transform, with another name.
     *
     * @throws enlightenment.math.InvalidValueException (key {@code transform}) if its shape cannot be transformed so
     */
    public SceneObject placed(Transform transform, String newName) {
        // A mirrored cube is one that is turned, with each pair of opposite faces exchanged.
        List<Material> placed = faces.isEmpty() || !transform.isMirror()
                ? faces
                : List.of(faces.get(1), faces.get(0), faces.get(3), faces.get(2), faces.get(5), faces.get(4));
        return new SceneObject(newName, shape.placed(transform), material, placed);
    }

    /**
     * The material of a face.
     *
     * @param face 0..5 of a cube with faces, in their order; ignored where there is only one material
     */
    public Material materialOf(int face) {
        return faces.isEmpty() ? material : faces.get(face);
    }
}
