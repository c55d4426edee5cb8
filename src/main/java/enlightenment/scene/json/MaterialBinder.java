package enlightenment.scene.json;

import enlightenment.color.DisplayRgb;
import enlightenment.material.Material;
import enlightenment.material.Texture;
import enlightenment.math.Check.InvalidValueException;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** Reads textures and materials. A name whose value failed stays known, as null, so that its uses are not blamed. */
final class MaterialBinder {
    private static final String[] TYPES = {"matte", "mirror", "glass"};
    private static final String[] FUTURE_TYPES = {"glossy", "scattering", "fluorescent"};
    private static final String IMAGE = "a PNG, JPEG or BMP file";

    private final Values values;
    private final Problems problems;
    private final Path folder;
    final Map<String, Texture> textures = new LinkedHashMap<>();
    final Map<String, Material> materials = new LinkedHashMap<>();

    MaterialBinder(Values values, Path folder) {
        this.values = values;
        this.problems = values.problems;
        this.folder = folder;
    }

    void readTextures(Node node) {
        Node.Obj named = values.object(node, "an object that gives textures names");
        for (int i = 0; named != null && i < named.size(); i++) {
            Node.Obj o = values.object(named.value(i), "a texture (an object)");
            textures.put(named.key(i), o == null ? null : texture(o));
        }
    }

    void readMaterials(Node node) {
        Node.Obj named = values.object(node, "an object that gives materials names");
        for (int i = 0; named != null && i < named.size(); i++) {
            Node.Obj o = values.object(named.value(i), "a material (an object)");
            materials.put(named.key(i), o == null ? null : inline(o));
        }
    }

    private Texture texture(Node.Obj o) {
        Fields f = new Fields(o, values);
        String type = f.word("type", "a type of texture", "file", "checker", "solid");
        if (type == null) {
            return null;
        }
        try {
            switch (type) {
                case "file":
                    return file(f.only("a texture of a file", "type", "file", "filter", "encoding"));
                case "checker":
                    return checker(f.only("a checker texture", "type", "colors", "scale"));
                default:
                    DisplayRgb color =
                            f.only("a solid texture", "type", "color").color("color");
                    return color == null ? null : Texture.of(color);
            }
        } catch (InvalidValueException e) {
            f.refuse(e);
            return null;
        }
    }

    private Texture checker(Fields f) {
        double scale = f.number("scale");
        Node colors = f.required("colors", "two colours");
        List<Node> two = colors == null ? null : values.array(colors, 2, "an array of two colours");
        if (two == null) {
            return null;
        }
        DisplayRgb a = values.color(two.get(0));
        DisplayRgb b = values.color(two.get(1));
        return f.sound() ? new Texture.Checker(List.of(a, b), scale) : null;
    }

    private Texture file(Fields f) {
        String filter = f.word("filter", "a filter", "bilinear", "nearest");
        String encoding = f.word("encoding", "an encoding", "srgb", "linear");
        Node node = f.required("file", "the path of " + IMAGE);
        Path path = node == null ? null : image(node);
        if (!f.sound() || path == null) {
            return null;
        }
        return new Texture.File(
                path,
                filter.equals("nearest") ? Texture.Filter.NEAREST : Texture.Filter.BILINEAR,
                encoding.equals("linear") ? Texture.Encoding.LINEAR : Texture.Encoding.SRGB);
    }

    private Path image(Node node) {
        String text = values.string(node);
        if (text == null) {
            return null;
        }
        String expected = "must be the path of " + IMAGE + "; ";
        Path path;
        try {
            path = folder.resolve(text).normalize();
        } catch (InvalidPathException e) {
            problems.at(node, expected + Node.quote(text) + " is no path");
            return null;
        }
        if (!Files.exists(path)) {
            problems.at(node, expected + "there is no file " + path);
        } else if (!Files.isRegularFile(path)) {
            problems.at(node, expected + path + " is not a file");
        } else {
            checkFormat(node, expected, path);
        }
        return path;
    }

    private void checkFormat(Node node, String expected, Path path) {
        try (InputStream in = Files.newInputStream(path)) {
            if (!isImage(in.readNBytes(8))) {
                problems.at(node, expected + path + " begins like none of them");
            }
        } catch (IOException e) {
            problems.at(node, expected + path + " cannot be read");
        }
    }

    private static boolean isImage(byte[] b) {
        return begins(b, 0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n')
                || begins(b, 0xff, 0xd8, 0xff)
                || begins(b, 'B', 'M');
    }

    private static boolean begins(byte[] found, int... magic) {
        if (found.length < magic.length) {
            return false;
        }
        for (int i = 0; i < magic.length; i++) {
            if ((found[i] & 0xff) != magic[i]) {
                return false;
            }
        }
        return true;
    }

    /** The material that a name or an inline object gives; null where there is none. */
    Material material(Node node) {
        if (node instanceof Node.Str) {
            String name = ((Node.Str) node).text;
            Material m = materials.get(name);
            if (m == null) {
                missing(node, "material", name, materials);
            }
            return m;
        }
        Node.Obj o = values.object(node, "the name of a material, or a material (an object)");
        return o == null ? null : inline(o);
    }

    private void missing(Node node, String what, String name, Map<String, ?> known) {
        if (known.containsKey(name)) {
            // It failed where it stands.
            problems.fail();
            return;
        }
        problems.at(
                node,
                "there is no " + what + " " + Node.quote(name) + " in \"" + what + "s\""
                        + problems.suggestion(name, known.keySet()));
    }

    private Material inline(Node.Obj o) {
        Node type = o.get("type");
        if (type instanceof Node.Str && List.of(FUTURE_TYPES).contains(((Node.Str) type).text)) {
            problems.at(
                    type,
                    "material " + type.describe().substring("the string ".length())
                            + " is not available yet; expected one of " + Values.list(TYPES));
            return null;
        }
        Fields f = new Fields(o, values);
        String kind = f.requiredWord("type", "a type of material", TYPES);
        if (kind == null) {
            return null;
        }
        boolean receivesShadows = f.truth("receivesShadows", true);
        Texture color = color(f.required("color", "a colour"));
        try {
            switch (kind) {
                case "matte":
                    f.only("a matte material", "type", "color", "receivesShadows");
                    return f.sound() ? new Material.Matte(color, receivesShadows) : null;
                case "mirror":
                    f.only("a mirror", "type", "color", "receivesShadows");
                    return f.sound() ? new Material.Mirror(color, receivesShadows) : null;
                default:
                    return glass(f, color, receivesShadows);
            }
        } catch (InvalidValueException e) {
            f.refuse(e);
            return null;
        }
    }

    private Material glass(Fields f, Texture color, boolean receivesShadows) {
        f.only("glass", "type", "color", "receivesShadows", "indexOfRefraction", "transparency", "priority");
        double index = f.number("indexOfRefraction");
        double transparency = f.number("transparency", 1);
        int priority = (int) f.whole("priority", Integer.MIN_VALUE, Integer.MAX_VALUE, 0);
        return f.sound() ? new Material.Glass(color, index, transparency, priority, receivesShadows) : null;
    }

    private Texture color(Node node) {
        if (node == null) {
            return null;
        }
        if (node instanceof Node.Obj) {
            Fields f = new Fields((Node.Obj) node, values).only("a reference to a texture", "texture");
            Node name = f.required("texture", "the name of a texture");
            String text = name == null ? null : values.string(name);
            Texture t = text == null ? null : textures.get(text);
            if (text != null && t == null) {
                missing(name, "texture", text, textures);
            }
            return t;
        }
        DisplayRgb color = values.color(node);
        return color == null ? null : Texture.of(color);
    }
}
