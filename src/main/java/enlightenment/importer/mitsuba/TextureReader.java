package enlightenment.importer.mitsuba;

import enlightenment.color.Rgb;
import enlightenment.image.Image;
import enlightenment.image.ImageFiles;
import enlightenment.importer.support.Affine;
import enlightenment.importer.support.UvMap;
import enlightenment.material.Texture;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/** Reads the textures of one surface, and what they do to its texture coordinates. */
final class TextureReader {
    private final SceneIndex scene;
    private final ColorValue colors;

    /** What the textures so far do to texture coordinates; null before the first. */
    private UvMap map;

    TextureReader(SceneIndex scene) {
        this.scene = scene;
        colors = new ColorValue(scene);
    }

    /** What the textures do to texture coordinates. */
    UvMap map() {
        return map == null ? UvMap.IDENTITY : map;
    }

    /** A property that is a colour or a texture, of a reflectance: at most 1. */
    Texture reflectance(Properties p, String name, double otherwise) {
        return p.find(name).map(e -> texture(e, true)).orElse(Texture.of(Rgb.gray(otherwise)));
    }

    /** A property that is a colour; the mean of a checker, and the default of a picture. */
    Rgb color(Properties p, String name, double otherwise) {
        Optional<XmlElement> e = p.find(name).map(scene::resolved);
        if (e.isEmpty()) {
            return Rgb.gray(otherwise);
        }
        return e.get().tag().equals("texture") ? mean(e.get()) : colors.factor(e.get());
    }

    /** A property that is a number, or the mean of a texture. */
    double number(Properties p, String name, double otherwise) {
        Rgb v = color(p, name, otherwise);
        return (v.r() + v.g() + v.b()) / 3;
    }

    /** The mean of a texture, with a note; grey for a picture that cannot be read. */
    Rgb mean(XmlElement e) {
        Texture texture = texture(e, false);
        if (texture instanceof Texture.Solid solid) {
            return solid.color().linear();
        }
        scene.note(e, "a texture of a number, or of light, becomes its mean");
        if (texture instanceof Texture.Checker c) {
            Rgb one = c.colors().get(0).linear();
            Rgb two = c.colors().get(1).linear();
            return new Rgb((one.r() + two.r()) / 2, (one.g() + two.g()) / 2, (one.b() + two.b()) / 2);
        }
        Texture.File file = (Texture.File) texture;
        try {
            Image image = ImageFiles.read(file.file());
            return PictureMean.of(image, file.encoding() == Texture.Encoding.SRGB);
        } catch (IOException problem) {
            scene.note(e, "a texture is left out: " + problem.getMessage());
            return Rgb.gray(0.5);
        }
    }

    /**
     * A colour or a texture.
     *
     * @param isReflectance whether no component may be above 1
     */
    Texture texture(XmlElement reference, boolean isReflectance) {
        XmlElement e = scene.resolved(reference);
        if (!e.tag().equals("texture")) {
            return Texture.of(limited(e, colors.factor(e), isReflectance));
        }
        Properties p = new Properties(e);
        Texture texture =
                switch (e.type()) {
                    case "bitmap" -> bitmap(p);
                    case "checkerboard" -> checker(p, isReflectance);
                    default -> {
                        scene.note(e, e.described() + " is left out; its surface becomes grey");
                        yield Texture.of(Rgb.gray(0.5));
                    }
                };
        if (!(texture instanceof Texture.Solid)) {
            scene.noteUnused(p);
        }
        return texture;
    }

    private Rgb limited(XmlElement e, Rgb c, boolean isReflectance) {
        if (!isReflectance || c.max() <= 1) {
            return c;
        }
        scene.note(e, "a reflectance above 1 becomes 1");
        return new Rgb(StrictMath.min(c.r(), 1), StrictMath.min(c.g(), 1), StrictMath.min(c.b(), 1));
    }

    private Texture bitmap(Properties p) {
        XmlElement e = p.element();
        Texture.Filter filter =
                p.text("filter_type", "bilinear").equals("nearest") ? Texture.Filter.NEAREST : Texture.Filter.BILINEAR;
        boolean isLinear = p.flag("raw", false) || p.number("gamma", 0) == 1;
        if (!p.text("wrap_mode", "repeat").equals("repeat")) {
            scene.note(e, "a texture that does not repeat repeats");
        }
        p.ignore("accel", "format", "cache", "max_anisotropy");
        use(e, uvMap(p));
        try {
            Path file = scene.file(p.text("filename", ""));
            return new Texture.File(
                    file, filter, isLinear || isOfFloats(file) ? Texture.Encoding.LINEAR : Texture.Encoding.SRGB);
        } catch (IOException problem) {
            scene.note(e, "a texture is left out: " + problem.getMessage());
            return Texture.of(Rgb.gray(0.5));
        }
    }

    /** Whether a picture is of a format for light, which is never encoded for screens. */
    static boolean isOfFloats(Path file) {
        return file.toString().toLowerCase(Locale.ROOT).matches(".*\\.(exr|hdr|rgbe|pfm)");
    }

    private Texture checker(Properties p, boolean isReflectance) {
        List<enlightenment.color.Color> two = new ArrayList<>();
        for (String name : List.of("color0", "color1")) {
            Optional<XmlElement> e = p.find(name).map(scene::resolved);
            double otherwise = name.equals("color0") ? 0.4 : 0.2;
            if (e.isPresent() && e.get().tag().equals("texture")) {
                scene.note(e.get(), "a texture inside of a checkerboard becomes grey");
            }
            two.add(
                    e.isEmpty() || e.get().tag().equals("texture")
                            ? Rgb.gray(otherwise)
                            : limited(e.get(), colors.factor(e.get()), isReflectance));
        }
        UvMap uv = uvMap(p);
        if (uv.isScale()) {
            use(p.element(), UvMap.IDENTITY);
            return new Texture.Checker(two, 2 * uv.a());
        }
        use(p.element(), uv);
        return new Texture.Checker(two, 2);
    }

    private static UvMap uvMap(Properties p) {
        Affine m = p.transform("to_uv");
        Affine old = Affine.translate(p.number("uoffset", 0), p.number("voffset", 0), 0)
                .after(Affine.scale(p.number("uscale", 1), p.number("vscale", 1), 1));
        return UvMap.of(m.after(old));
    }

    private void use(XmlElement e, UvMap uv) {
        if (map == null) {
            map = uv;
        } else if (!map.equals(uv)) {
            scene.note(e, "the second one of two different to_uv of a surface is left out");
        }
    }
}
