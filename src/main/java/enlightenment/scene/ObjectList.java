package enlightenment.scene;

import enlightenment.geometry.Shape;
import enlightenment.material.Material;
import java.util.AbstractList;
import java.util.List;
import java.util.RandomAccess;

/**
 * The immutable objects of a scene. Shapes and materials are stored side by side; {@link #get} makes a {@link SceneObject} of them. Of a
 * million objects most have neither a name nor faces, and an object that only joins two references takes as much memory as a sphere.
 */
final class ObjectList extends AbstractList<SceneObject> implements RandomAccess {
    private final Shape[] shapes;
    private final Material[] materials;

    /** Null where no object has a name. */
    private final String[] names;

    /** By index; null where no object has faces of its own. */
    private final List<Material>[] faces;

    private ObjectList(List<SceneObject> objects) {
        int n = objects.size();
        shapes = new Shape[n];
        materials = new Material[n];
        names = objects.stream().allMatch(o -> o.name().isEmpty()) ? null : new String[n];
        faces = objects.stream().allMatch(o -> o.faces().isEmpty()) ? null : lists(n);
        for (int i = 0; i < n; i++) {
            SceneObject o = objects.get(i);
            shapes[i] = o.shape();
            materials[i] = o.material();
            if (names != null) {
                names[i] = o.name();
            }
            if (faces != null) {
                faces[i] = o.faces();
            }
        }
    }

    /** An array's elements cannot be generic; this one is never seen outside. */
    @SuppressWarnings("unchecked")
    private static List<Material>[] lists(int n) {
        return (List<Material>[]) new List<?>[n];
    }

    /**
     * A list of these objects, or the list itself if it is one.
     *
     * @throws NullPointerException if the list or an object is missing; the message says which
     */
    static List<SceneObject> copyOf(List<SceneObject> objects) {
        return objects instanceof ObjectList ? objects : new ObjectList(Present.list("objects", "object", objects));
    }

    @Override
    public int size() {
        return shapes.length;
    }

    @Override
    public SceneObject get(int i) {
        String name = names == null ? "" : names[i];
        return new SceneObject(name, shapes[i], materials[i], faces == null ? List.of() : faces[i]);
    }
}
