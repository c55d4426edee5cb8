package enlightenment.scene.json;

import enlightenment.material.Material;
import enlightenment.material.Texture;
import enlightenment.scene.Scene;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/** Writes textures and materials, by name where they have one. */
final class MaterialText {
    private final Path folder;
    private final boolean full;
    private final boolean colorsAsNumbers;
    /** What is written at "textures", and under which name. */
    private final Map<String, Texture> textures;

    private final Map<Texture, String> sameTexture = new IdentityHashMap<>();
    private final Map<Texture, String> equalTexture = new HashMap<>();
    private final Map<Material, String> sameMaterial = new IdentityHashMap<>();
    private final Map<Material, String> equalMaterial = new HashMap<>();
    private int generated;

    /**
     * @param full whether an animation may point into what is written, so that every number must stay where it was
     * @param colorsAsNumbers whether colours must be written by their components
     */
    MaterialText(Scene scene, Path folder, boolean full, boolean colorsAsNumbers) {
        this.folder = folder.toAbsolutePath().normalize();
        this.full = full;
        this.colorsAsNumbers = colorsAsNumbers;
        this.textures = new LinkedHashMap<>(scene.textures());
        for (Map.Entry<String, Texture> e : scene.textures().entrySet()) {
            sameTexture.putIfAbsent(e.getValue(), e.getKey());
            equalTexture.putIfAbsent(e.getValue(), e.getKey());
        }
        for (Map.Entry<String, Material> e : scene.materials().entrySet()) {
            sameMaterial.putIfAbsent(e.getValue(), e.getKey());
            equalMaterial.putIfAbsent(e.getValue(), e.getKey());
        }
    }

    /** The textures, those included that {@link #material} and {@link #definition} gave a name; call it last. */
    Map<String, Object> textures() {
        Map<String, Object> to = new LinkedHashMap<>();
        for (Map.Entry<String, Texture> e : textures.entrySet()) {
            to.put(e.getKey(), texture(e.getValue()));
        }
        return to;
    }

    private Object texture(Texture texture) {
        Map<String, Object> to = new LinkedHashMap<>();
        if (texture instanceof Texture.File f) {
            to.put("file", JsonText.quote(path(f.file())));
            if (f.filter() != Texture.Filter.BILINEAR) {
                to.put("filter", word(f.filter()));
            }
            if (f.encoding() != Texture.Encoding.SRGB) {
                to.put("encoding", word(f.encoding()));
            }
        } else if (texture instanceof Texture.Checker c) {
            to.put("type", "\"checker\"");
            to.put(
                    "colors",
                    List.of(
                            Tokens.color(c.colors().get(0), colorsAsNumbers),
                            Tokens.color(c.colors().get(1), colorsAsNumbers)));
            to.put("scale", Tokens.number(c.scale()));
        } else {
            to.put("type", "\"solid\"");
            to.put("color", Tokens.color(((Texture.Solid) texture).color(), colorsAsNumbers));
        }
        return to;
    }

    private static String word(Enum<?> e) {
        return JsonText.quote(e.name().toLowerCase(Locale.ROOT));
    }

    private String path(Path file) {
        Path absolute = file.toAbsolutePath().normalize();
        if (!absolute.getFileSystem().equals(folder.getFileSystem())
                || absolute.getRoot() == null
                || !absolute.getRoot().equals(folder.getRoot())) {
            return absolute.toString();
        }
        String relative = folder.relativize(absolute).toString();
        return relative.replace(folder.getFileSystem().getSeparator(), "/");
    }

    /** A material's name, or the material itself where it has none. */
    Object material(Material material) {
        String name = sameMaterial.get(material);
        if (name == null && !full) {
            name = equalMaterial.get(material);
        }
        return name == null ? definition(material) : JsonText.quote(name);
    }

    /** The material itself. */
    Object definition(Material material) {
        Map<String, Object> to = new LinkedHashMap<>();
        to.put("type", JsonText.quote(material.type()));
        to.put("color", color(material.color()));
        if (material instanceof Material.Glass g) {
            to.put("indexOfRefraction", Tokens.number(g.indexOfRefraction()));
            if (full || g.transparency() != 1) {
                to.put("transparency", Tokens.number(g.transparency()));
            }
            if (full || g.priority() != 0) {
                to.put("priority", Integer.toString(g.priority()));
            }
        }
        if (!material.receivesShadows()) {
            to.put("receivesShadows", "false");
        }
        return to;
    }

    private Object color(Texture texture) {
        String name = sameTexture.get(texture);
        if (name == null && texture instanceof Texture.Solid s) {
            return Tokens.color(s.color(), colorsAsNumbers);
        }
        if (name == null) {
            name = equalTexture.get(texture);
        }
        if (name == null) {
            do {
                name = "texture" + ++generated;
            } while (textures.containsKey(name));
            textures.put(name, texture);
            equalTexture.put(texture, name);
        }
        return Map.of("texture", JsonText.quote(name));
    }
}
