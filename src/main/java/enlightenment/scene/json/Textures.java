package enlightenment.scene.json;

import enlightenment.color.DisplayRgb;
import enlightenment.image.ImageFormat;
import enlightenment.material.Texture;
import enlightenment.text.Plain;
import enlightenment.text.Suggestion;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;

/** Reads the named textures, and the colours that use them. */
final class Textures {
    private static final Fields.Family FAMILY =
            new Fields.Family("a texture", Vocabulary.TEXTURES, List.of(), List.of());
    private static final String COLOR = Values.COLOR + ", [r, g, b] with components in 0..1, or {\"texture\": NAME}";

    private final Values values;
    private final Path folder;
    /** Names of image files that are not on the disk; null if they are. */
    private final Set<String> fileNames;

    /** Null for a texture that is there but wrong: its own problem is enough. */
    private final Map<String, Texture> named = new LinkedHashMap<>();

    /**
     * @param folder what the paths of image files are relative to
     * @param fileNames the names of image files that are not on the disk, or null if they are
     */
    Textures(Values values, Path folder, Set<String> fileNames) {
        this.fileNames = fileNames;
        this.values = values;
        this.folder = folder.toAbsolutePath();
    }

    /** Reads the part {@code textures}. */
    void readNamed(JsonValue v, JsonPointer place) {
        JsonValue.Obj o = values.object(v, place, "textures by their names");
        for (int i = 0; o != null && i < o.size(); i++) {
            named.put(o.key(i), texture(o.value(i), place.child(o.key(i))));
        }
    }

    Map<String, Texture> named() {
        return named;
    }

    /** The colour of a material; null after a problem, here or where the texture has its name. */
    Texture color(JsonValue v, JsonPointer place) {
        int before = values.problems().count();
        if (!(v instanceof JsonValue.Obj)) {
            DisplayRgb c = values.color(v, place, COLOR);
            return values.problems().count() > before ? null : Texture.of(c);
        }
        Fields f = Fields.of(v, place, Vocabulary.TEXTURE_REFERENCE, values);
        String name = f.text("texture", "the name of a texture");
        if (name == null || named.containsKey(name)) {
            return name == null ? null : named.get(name);
        }
        String there = Suggestion.of(name, named.keySet(), "there are");
        String none = "; the scene names no textures (/textures)";
        f.problem("texture", "unknown texture " + Plain.quoted(name) + (named.isEmpty() ? none : there));
        return null;
    }

    private Texture texture(JsonValue v, JsonPointer place) {
        Fields f = Fields.of(v, place, FAMILY, "file", values);
        if (f == null) {
            return null;
        }
        switch (f.type("file")) {
            case "checker":
                return checker(f);
            case "color": {
                DisplayRgb c = f.color("color", DisplayRgb.BLACK);
                return f.make(() -> Texture.of(c));
            }
            default:
                return file(f);
        }
    }

    private Texture checker(Fields f) {
        List<DisplayRgb> colors = new ArrayList<>();
        JsonValue v = f.get("colors");
        JsonValue.Arr a = v == null ? null : values.array(v, f.at("colors"), 2, "an array of two colours");
        for (int i = 0; a != null && i < 2; i++) {
            colors.add(values.color(a.get(i), f.at("colors").child(i)));
        }
        double scale = f.number("scale");
        return f.make(() -> new Texture.Checker(colors, scale));
    }

    private Texture file(Fields f) {
        String written = f.text("file", "the path of an image file");
        String filter = f.word("filter", Vocabulary.FILTERS, List.of(), "bilinear");
        String encoding = f.word("encoding", Vocabulary.ENCODINGS, List.of(), "srgb");
        Path file = written == null ? null : imageFile(f, written);
        return f.make(() -> new Texture.File(
                file,
                filter.equals("nearest") ? Texture.Filter.NEAREST : Texture.Filter.BILINEAR,
                encoding.equals("linear") ? Texture.Encoding.LINEAR : Texture.Encoding.SRGB));
    }

    /** The file that is meant, after a look at whether it is one. */
    private Path imageFile(Fields f, String written) {
        if (fileNames != null) {
            if (!fileNames.contains(written)) {
                f.problem("file", "there is no image " + Plain.quoted(written));
                return null;
            }
            return Path.of(written);
        }
        Path file;
        try {
            file = folder.resolve(written).normalize();
        } catch (InvalidPathException e) {
            f.problem("file", "is not a path: " + Plain.quoted(written));
            return null;
        }
        String meant = Plain.quoted(written) + " (" + file + ")";
        if (!Files.exists(file)) {
            f.problem("file", "there is no file " + meant);
        } else if (!Files.isRegularFile(file)) {
            f.problem("file", "is not a file: " + meant);
        } else {
            try (InputStream in = Files.newInputStream(file)) {
                byte[] start = in.readNBytes(ImageFormat.SIGNATURE_LENGTH);
                List<ImageFormat> usable = ImageFormat.textures();
                if (ImageFormat.ofContent(start).filter(usable::contains).isEmpty()) {
                    f.problem("file", "is not an image: " + meant + " is neither " + ImageFormat.names(usable, "nor"));
                }
            } catch (IOException e) {
                f.problem("file", "cannot be read: " + meant + ": " + e);
            }
        }
        return file;
    }
}
