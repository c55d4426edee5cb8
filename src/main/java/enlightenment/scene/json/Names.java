package enlightenment.scene.json;

import enlightenment.light.Light;
import enlightenment.material.Material;
import enlightenment.material.Texture;
import enlightenment.mesh.TriangleMesh;
import enlightenment.scene.Scene;
import enlightenment.scene.SceneObject;
import enlightenment.scene.Shading;
import enlightenment.scene.json.tree.JsonPointer;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;

/** How a scene's textures, materials and image files are called in its text, and which of its numbers are animated. */
final class Names {
    private final FileNaming fileNames;
    private final TreeSet<String> targets = new TreeSet<>();
    private final Map<String, Texture> textures;
    private final Map<Texture, String> textureNames = new HashMap<>();
    private final Set<String> written = new HashSet<>();
    private final Map<Material, String> materialNames = new HashMap<>();

    /** @param fileNames how image files are called in the text */
    Names(Scene scene, FileNaming fileNames) {
        this.fileNames = fileNames;
        this.textures = new LinkedHashMap<>(scene.textures());
        scene.animation().ifPresent(a -> a.tracks().forEach(t -> targets.add(t.target())));
        textures.forEach((name, texture) -> textureNames.putIfAbsent(texture, name));
        scene.materials().forEach((name, material) -> materialNames.putIfAbsent(material, name));
        scene.materials().values().forEach(this::nameTexture);
        for (SceneObject object : scene.objects()) {
            nameTexture(object.material());
            object.faces().forEach(this::nameTexture);
        }
        for (Light light : scene.lights()) {
            if (light instanceof Light.Projector projector) {
                nameTexture(projector.picture());
            }
        }
        if (scene.shading() instanceof Shading.Physical shading
                && shading.background() instanceof Shading.Background.Picture surroundings) {
            nameTexture(surroundings.picture());
        }
    }

    /** In the format only colours can stand where they are used, and where colours may stand: every other texture needs a name. */
    private void nameTexture(Material material) {
        nameTexture(material.color());
        List<Texture> others = new ArrayList<>(material.textures());
        material.radianceMap().ifPresent(map -> {
            others.remove(others.lastIndexOf(map));
            nameTexture(map);
        });
        others.forEach(this::addName);
        material.parts().forEach(this::nameTexture);
    }

    private void nameTexture(Texture texture) {
        if (!(texture instanceof Texture.Solid)) {
            addName(texture);
        }
    }

    private void addName(Texture texture) {
        if (textureNames.containsKey(texture)) {
            return;
        }
        int n = 1;
        while (textures.containsKey("texture " + n)) {
            n++;
        }
        textures.put("texture " + n, texture);
        textureNames.put(texture, "texture " + n);
    }

    /** The scene's textures by their names, and those that got one here. */
    Map<String, Texture> textures() {
        return textures;
    }

    /** A texture's name; null for a colour without one. */
    String of(Texture texture) {
        return textureNames.get(texture);
    }

    /** A material's name; null if it has none, or none that is in the text already: parts are named before what they are parts of. */
    String of(Material material) {
        String name = materialNames.get(material);
        return written.contains(name) ? name : null;
    }

    /** Notes that the material of a name is in the text now. */
    void wroteMaterial(String name) {
        written.add(name);
    }

    String of(Path file) {
        return fileNames.of(file);
    }

    /** The name of a file that holds a mesh as it is; empty if the one that it was read from is to be named. */
    Optional<String> of(TriangleMesh mesh) {
        return fileNames.of(mesh);
    }

    /** Whether a value, or something inside of it, is animated: then it must be written as numbers, at just that place. */
    boolean isAnimated(JsonPointer place) {
        if (targets.isEmpty()) {
            return false;
        }
        String p = place.toString();
        String inside = targets.ceiling(p + "/");
        return targets.contains(p) || inside != null && inside.startsWith(p + "/");
    }
}
