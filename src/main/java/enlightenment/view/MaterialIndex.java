package enlightenment.view;

import enlightenment.material.Material;
import enlightenment.scene.Scene;
import enlightenment.scene.SceneObject;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** A number for each material of a scene, in the order of its objects; lights and objects with a material for each face count as one each. */
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

    /** The number of the material of an object or, counted on after the last object, of a light; −1 for −1. */
    int of(int object) {
        return object < 0 || object >= ofObject.length ? -1 : ofObject[object];
    }

    /** What a number stands for. */
    String name(int material) {
        return names.get(material);
    }
}
