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

/** Names of a scene's textures, materials and files in its text, and the targets of its tracks. */
final class Names {
    private final FileNaming fileNames;
    private final TreeSet<String> targets = new TreeSet<>();
    private final Map<String, Texture> textures;
    private final Map<Texture, String> textureNames = new HashMap<>();
    private final Set<String> written = new HashSet<>();
    private final Map<Material, String> materialNames = new HashMap<>();

    /** @param fileNames names of image files in the text */
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

    /** Names the textures of a material; solid ones only where the format has no colour in place. */
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

    /** The textures by name, those that were named here included. */
    Map<String, Texture> textures() {
        return textures;
    }

    /** A texture's name; null for a colour without one. */
    String of(Texture texture) {
        return textureNames.get(texture);
    }

    /** A material's name, if that has been written already, as parts of materials come before their wholes; else null. */
    String of(Material material) {
        String name = materialNames.get(material);
        return written.contains(name) ? name : null;
    }

    /** Records that the material of a name has been written. */
    void wroteMaterial(String name) {
        written.add(name);
    }

    String of(Path file) {
        return fileNames.of(file);
    }

    /** The name of a file that holds exactly this mesh; empty to write the original file. */
    Optional<String> of(TriangleMesh mesh) {
        return fileNames.of(mesh);
    }

    /** Whether a value or a part of it is the target of a track. Such values must be written as numbers in place. */
    boolean isAnimated(JsonPointer place) {
        if (targets.isEmpty()) {
            return false;
        }
        String p = place.toString();
        String inside = targets.ceiling(p + "/");
        return targets.contains(p) || inside != null && inside.startsWith(p + "/");
    }
}
