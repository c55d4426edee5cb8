package enlightenment.view;

import enlightenment.material.Material;
import enlightenment.scene.Scene;
import enlightenment.scene.SceneObject;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * Numbers of the materials of a scene, in the order of its objects. Each light, and each object with a material for each face, has a number of
 * its own.
 */
final class MaterialIndex {
    private final int[] ofObject;
    private final List<String> names = new ArrayList<>();

    MaterialIndex(Scene scene) {
        Map<Material, String> named = new HashMap<>();
        scene.materials().forEach((name, material) -> named.putIfAbsent(material, name + " (" + material.type() + ")"));
        int objects = scene.objects().size();
        ofObject = new int[objects + scene.lights().size()];
        Map<Material, Integer> numbers = new HashMap<>();
        for (int i = 0; i < objects; i++) {
            SceneObject object = scene.objects().get(i);
            Material material = object.material();
            if (!object.faces().isEmpty()) {
                ofObject[i] =
                        add("one for each face: " + PixelProbe.object(scene, i).orElseThrow());
            } else {
                ofObject[i] = numbers.computeIfAbsent(material, m -> add(named.getOrDefault(m, m.type())));
            }
        }
        for (int i = objects; i < ofObject.length; i++) {
            ofObject[i] = add(PixelProbe.object(scene, i).orElseThrow());
        }
    }

    private int add(String name) {
        names.add(name);
        return names.size() - 1;
    }

    /** The material number of an object or light; lights are counted on after the last object. −1 if the number is neither. */
    int of(int object) {
        return object < 0 || object >= ofObject.length ? -1 : ofObject[object];
    }

    /** The name of a material or light by its number. */
    String name(int material) {
        return names.get(material);
    }
}
