package enlightenment.scene.json;

import enlightenment.color.Color;
import enlightenment.color.DisplayRgb;
import enlightenment.image.ImageFormat;
import enlightenment.material.Texture;
import enlightenment.scene.json.tree.JsonPointer;
import enlightenment.scene.json.tree.JsonValue;
import enlightenment.text.PathText;
import enlightenment.text.Plain;
import enlightenment.text.Suggestion;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** Reads and writes named textures, and colours that refer to them. */
final class Textures {
    static final Family<Texture> FAMILY = new Family<Texture>(
                    "texture", "a texture", "file", Map.of(), Textures::read, Textures::write)
            .with("file", Texture.File.class, "file | filter encoding")
            .with("checker", Texture.Checker.class, "colors scale |")
            .with("color", Texture.Solid.class, "color |");

    private static final String COLOR =
            Values.COLOR + ", [r, g, b] with components in 0..1, " + Values.LINEAR + ", or {\"texture\": NAME}";

    /** Keys that distinguish the forms of colours given as objects. */
    private static final List<String> KINDS = List.of("linear", "texture");

    private Textures() {}

    private static Texture read(String type, Fields f) {
        return switch (type) {
            case "file" -> file(f);
            case "checker" -> checker(f);
            case "color" -> solid(f);
            default -> throw Family.unknown(type);
        };
    }

    private static void write(Texture value, JsonObjectBuilder p) {
        if (value instanceof Texture.File t) {
            p.file("file", t.file())
                    .wordUnless(Texture.Filter.BILINEAR, "filter", t.filter())
                    .wordUnless(Texture.Encoding.SRGB, "encoding", t.encoding());
        } else if (value instanceof Texture.Checker c) {
            p.colors("colors", c.colors()).number("scale", c.scale());
        } else if (value instanceof Texture.Solid s) {
            p.color("color", s.color());
        } else {
            throw Family.unknown(value);
        }
    }

    /** Reads the part {@code textures} into the library. */
    static void readNamed(JsonValue v, JsonPointer place, Values values) {
        JsonValue.Obj o = values.object(v, place, "textures by their names");
        for (int i = 0; o != null && i < o.size(); i++) {
            Fields f = Fields.of(o.value(i), place.child(o.key(i)), FAMILY, values);
            values.library().textures.put(o.key(i), f == null ? null : FAMILY.read(f));
        }
    }

    /**
     * The colour of a material.
     *
     * @return black if it is missing; null after a problem of the colour or of its texture
     */
    static Texture color(Fields f, String key) {
        return f.has(key) ? color(f.get(key), f.at(key), f.values()) : Texture.of(DisplayRgb.BLACK);
    }

    private static Texture color(JsonValue v, JsonPointer place, Values values) {
        int before = values.problems().count();
        if (!(v instanceof JsonValue.Obj o) || o.get("linear") != null) {
            Color c = values.color(v, place, COLOR);
            return values.problems().count() > before ? null : Texture.of(c);
        }
        if (o.get("texture") == null) {
            values.problems().add(v, place, "must be " + COLOR + ", not " + Values.describe(o, KINDS));
            return null;
        }
        return ofSurface(Fields.of(v, place, PartKeys.TEXTURE_REFERENCE, values));
    }

    /** The texture that a part of a material refers to; null after a problem of reference or texture. */
    static Texture ofSurface(Fields f) {
        Texture texture = named(f);
        if (texture instanceof Texture.File file
                && f.values().library().lightFiles.contains(file.file())) {
            f.problem(
                    "texture",
                    "is a file of floats, which only a background can have: surfaces and projectors take "
                            + ImageFormat.names(ImageFormat.textures(), "and"));
            return null;
        }
        return texture;
    }

    /** The texture named by the key {@code "texture"}; null after a problem of the reference or of the texture. */
    static Texture named(Fields f) {
        String name = f.text("texture", "the name of a texture");
        Map<String, Texture> named = f.values().library().textures;
        if (name == null || named.containsKey(name)) {
            return name == null ? null : named.get(name);
        }
        String instead = named.isEmpty()
                ? "; the scene names no textures (/textures)"
                : Suggestion.of(name, named.keySet(), "there are");
        f.problem("texture", "unknown texture " + Plain.quoted(name) + instead);
        return null;
    }

    private static Texture solid(Fields f) {
        Color c = f.color("color", DisplayRgb.BLACK);
        return f.make(() -> Texture.of(c));
    }

    private static Texture checker(Fields f) {
        List<Color> colors = new ArrayList<>();
        JsonValue v = f.get("colors");
        JsonValue.Arr a = v == null ? null : f.values().array(v, f.at("colors"), 2, "an array of two colours");
        for (int i = 0; a != null && i < 2; i++) {
            colors.add(f.values().color(a.get(i), f.at("colors").child(i)));
        }
        double scale = f.number("scale");
        return f.make(() -> new Texture.Checker(colors, scale));
    }

    private static Texture file(Fields f) {
        String written = f.text("file", "the path of an image file");
        Texture.Filter filter = f.word("filter", Texture.Filter.BILINEAR);
        Texture.Encoding encoding = f.word("encoding", Texture.Encoding.SRGB);
        Path file = written == null ? null : imageFile(f, written);
        return f.make(() -> new Texture.File(file, filter, encoding));
    }

    /** The path of an image file, which exists and has the signature of an image; null after a problem. */
    private static Path imageFile(Fields f, String written) {
        Map<String, byte[]> contents = f.values().library().contents;
        if (contents != null) {
            if (!contents.containsKey(written)) {
                f.problem("file", "there is no image " + Plain.quoted(written));
                return null;
            }
            return Path.of(written);
        }
        Path file;
        try {
            file = f.values().library().folder.resolve(written).normalize();
        } catch (InvalidPathException e) {
            f.problem("file", PathText.reason(e));
            return null;
        }
        String problem = problem(
                file, Plain.quoted(written) + " (" + file + ")", f.values().library());
        if (problem != null) {
            f.problem("file", problem);
        }
        return file;
    }

    /** The reason to refuse a file, by its first bytes; null if there is none. */
    private static String problem(Path file, String meant, Library library) {
        if (!Files.exists(file)) {
            return "there is no file " + meant;
        }
        if (!Files.isRegularFile(file)) {
            return "is not a file: " + meant;
        }
        try (InputStream in = Files.newInputStream(file)) {
            byte[] start = in.readNBytes(ImageFormat.SIGNATURE_LENGTH);
            Optional<ImageFormat> format = ImageFormat.ofContent(start);
            if (format.isPresent() && format.get().holdsFloats()) {
                library.lightFiles.add(file);
            }
            return format.isPresent()
                    ? null
                    : "is not an image: " + meant + " is neither "
                            + ImageFormat.names(List.of(ImageFormat.values()), "nor");
        } catch (IOException e) {
            return "cannot be read: " + meant + ": " + e;
        }
    }
}
