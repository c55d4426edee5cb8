package enlightenment.importer.pbrt;

import enlightenment.color.Color;
import enlightenment.color.Rgb;
import enlightenment.colorimetry.TransferCurve;
import enlightenment.image.Image;
import enlightenment.image.ImageFiles;
import enlightenment.importer.support.ImportNotes;
import enlightenment.importer.support.UvMap;
import enlightenment.material.Texture;
import enlightenment.text.Plain;
import java.io.IOException;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;

/** The textures of a scene by name, and what materials make of them. */
final class Textures {
    private static final int DEEPEST = 64;
    private static final Rgb GREY = Rgb.gray(0.5);
    private static final Set<String> NOISE =
            Set.of("fbm", "marble", "windy", "wrinkled", "ptex", "dots", "bilerp", "directionmix");

    private final Map<String, TextureDefinition> colors = new HashMap<>();
    private final Map<String, TextureDefinition> numbers = new HashMap<>();
    private final Map<TextureDefinition, ResolvedTexture> resolved = new IdentityHashMap<>();
    private final TokenSource files;
    private final Spectra spectra;
    private final ImportNotes notes;
    private final DerivedPictures pictures;

    Textures(TokenSource files, Spectra spectra, ImportNotes notes, DerivedPictures pictures) {
        this.files = files;
        this.spectra = spectra;
        this.notes = notes;
        this.pictures = pictures;
    }

    /** Keeps a texture of colours or of numbers. */
    void define(String name, boolean isOfColors, TextureDefinition definition) {
        (isOfColors ? colors : numbers).put(name, definition);
    }

    /**
     * A parameter that is a colour or a texture of colours.
     *
     * @param usual its value if it is absent
     */
    ResolvedTexture color(Parameters p, String name, ColorSpace space, Rgb usual) {
        return value(p, name, space, true, Spectra.Kind.ALBEDO, usual, 0);
    }

    /** A parameter that is a number or a texture of numbers. */
    ResolvedTexture number(Parameters p, String name, double usual) {
        return value(p, name, ColorSpace.SRGB, false, Spectra.Kind.UNBOUNDED, Rgb.gray(usual), 0);
    }

    private ResolvedTexture value(
            Parameters p, String name, ColorSpace space, boolean isOfColors, Spectra.Kind kind, Rgb usual, int depth) {
        if (!p.isTexture(name)) {
            return ResolvedTexture.of(spectra.rgb(p, name, kind, space, usual));
        }
        String texture = p.string(name, "");
        Place place = p.find(name).orElseThrow().place();
        TextureDefinition d = (isOfColors ? colors : numbers).get(texture);
        if (d == null) {
            throw place.failure(
                    "there is no " + (isOfColors ? "spectrum" : "float") + " texture named " + Plain.quoted(texture));
        }
        if (depth > DEEPEST) {
            throw place.failure("textures refer to each other in a circle, or too deep: " + Plain.quoted(texture));
        }
        ResolvedTexture known = resolved.get(d);
        if (known == null) {
            known = resolved(d, isOfColors, depth + 1);
            resolved.put(d, known);
        }
        return known;
    }

    private ResolvedTexture resolved(TextureDefinition d, boolean isOfColors, int depth) {
        Parameters p = d.parameters();
        switch (d.type()) {
            case "constant":
                return operand(d, "value", isOfColors, Rgb.WHITE, depth);
            case "imagemap":
                return image(p);
            case "checkerboard":
                return checker(d, isOfColors, depth);
            case "scale":
                return scaled(
                        operand(d, "tex", isOfColors, Rgb.WHITE, depth),
                        value(p, "scale", d.space(), false, Spectra.Kind.UNBOUNDED, Rgb.WHITE, depth),
                        p.place());
            case "mix":
                return mixed(d, isOfColors, depth);
            default:
                String what = "a texture of the kind " + Plain.quoted(d.type()) + " is replaced by grey";
                if (!NOISE.contains(d.type())) {
                    throw p.place().failure("pbrt-v4 has no texture of the kind " + Plain.quoted(d.type()));
                }
                notes.add(p.place().shown(), what);
                return ResolvedTexture.of(GREY);
        }
    }

    private ResolvedTexture operand(TextureDefinition d, String name, boolean isOfColors, Rgb usual, int depth) {
        return value(d.parameters(), name, d.space(), isOfColors, Spectra.Kind.UNBOUNDED, usual, depth);
    }

    private ResolvedTexture scaled(ResolvedTexture a, ResolvedTexture b, Place place) {
        if (b.isSolid()) {
            return a.times(b.color());
        }
        if (a.isSolid()) {
            return b.times(a.color());
        }
        notes.add(place.shown(), "a texture that is scaled by a texture is not scaled");
        return a;
    }

    private ResolvedTexture mixed(TextureDefinition d, boolean isOfColors, int depth) {
        ResolvedTexture a = operand(d, "tex1", isOfColors, Rgb.BLACK, depth);
        ResolvedTexture b = operand(d, "tex2", isOfColors, Rgb.WHITE, depth);
        double amount = Math.min(
                1, mean(value(d.parameters(), "amount", d.space(), false, Spectra.Kind.UNBOUNDED, GREY, depth)));
        if (a.isSolid() && b.isSolid()) {
            return ResolvedTexture.of(blend(a.color(), b.color(), amount));
        }
        if (amount > 0 && amount < 1) {
            notes.add(d.parameters().place().shown(), "of mixed textures the one with more weight stays");
        }
        return amount > 0.5 ? b : a;
    }

    private static Rgb blend(Rgb a, Rgb b, double t) {
        return new Rgb(a.r() * (1 - t) + b.r() * t, a.g() * (1 - t) + b.g() * t, a.b() * (1 - t) + b.b() * t);
    }

    private ResolvedTexture checker(TextureDefinition d, boolean isOfColors, int depth) {
        Parameters p = d.parameters();
        ResolvedTexture a = operand(d, "tex1", isOfColors, Rgb.WHITE, depth);
        ResolvedTexture b = operand(d, "tex2", isOfColors, Rgb.BLACK, depth);
        boolean isFlat = p.integer("dimension", 2, 2, 3) == 2;
        if (isFlat && a.isSolid() && b.isSolid()) {
            List<Color> both = List.of(clamped(a.color()), clamped(b.color()));
            // Squares of side 1 in coordinates that the mesh has: the parity of floor(u) + floor(v).
            return new ResolvedTexture(new Texture.Checker(both, 1), Rgb.WHITE, uv(p));
        }
        notes.add(p.place().shown(), "a checkerboard of textures, or in space, is replaced by the mean of its colours");
        return a.isSolid() && b.isSolid() ? ResolvedTexture.of(blend(a.color(), b.color(), 0.5)) : a;
    }

    static Rgb clamped(Rgb c) {
        return new Rgb(Math.min(1, c.r()), Math.min(1, c.g()), Math.min(1, c.b()));
    }

    private ResolvedTexture image(Parameters p) {
        Place place = p.place();
        Path file = files.file(p.string("filename", ""), place);
        String encoding = p.string("encoding", "sRGB");
        boolean isLight = DerivedPictures.isOfFloats(file);
        if (!encoding.equals("sRGB") && !encoding.equals("linear")) {
            notes.add(place.shown(), "an image's encoding " + Plain.quoted(encoding) + " is taken for sRGB");
        }
        if (!p.string("wrap", "repeat").equals("repeat")) {
            notes.add(place.shown(), "an image repeats beyond its edges, where it should be black or clamped");
        }
        Texture.Encoding e = isLight || encoding.equals("linear") ? Texture.Encoding.LINEAR : Texture.Encoding.SRGB;
        Texture.Filter filter =
                p.string("filter", "bilinear").equals("point") ? Texture.Filter.NEAREST : Texture.Filter.BILINEAR;
        double scale = Math.max(0, p.number("scale", 1));
        Texture.File plain = new Texture.File(file, filter, e);
        if (p.isTrue("invert", false)) {
            Texture.File inverted =
                    pictures.of(plain, "inverted after times " + scale, rgb -> invert(rgb, scale), place);
            return new ResolvedTexture(inverted, Rgb.WHITE, uv(p));
        }
        return isLight ? bounded(plain, scale, p) : new ResolvedTexture(plain, Rgb.gray(scale), uv(p));
    }

    private static void invert(double[] rgb, double scale) {
        for (int c = 0; c < 3; c++) {
            rgb[c] = 1 - scale * rgb[c];
        }
    }

    /** Floats as a picture of 0..1, which textures have, with its factor. */
    private ResolvedTexture bounded(Texture.File floats, double scale, Parameters p) {
        double largest = DerivedPictures.largest(pictures.linear(floats, p.place()), 1);
        Texture.File numbers = pictures.of(
                floats,
                "of 0..1",
                rgb -> {
                    for (int c = 0; c < 3; c++) {
                        rgb[c] /= largest;
                    }
                },
                p.place());
        return new ResolvedTexture(numbers, Rgb.gray(scale * largest), uv(p));
    }

    UvChoice uvChoice(Place place) {
        return new UvChoice(place, notes, pictures);
    }

    private UvMap uv(Parameters p) {
        if (!p.string("mapping", "uv").equals("uv")) {
            notes.add(p.place().shown(), "a texture's mapping is replaced by texture coordinates");
            return UvMap.IDENTITY;
        }
        return new UvMap(
                p.number("uscale", 1), 0, p.number("udelta", 0), 0, p.number("vscale", 1), p.number("vdelta", 0));
    }

    /** An image file whose numbers are no colours. */
    Texture.File linearImage(String name, Place place) {
        return new Texture.File(files.file(name, place), Texture.Filter.BILINEAR, Texture.Encoding.LINEAR);
    }

    /** The mean of a texture of numbers. */
    private static double mean(ResolvedTexture t) {
        if (t.isSolid()) {
            return mean(t.color());
        }
        if (t.texture() instanceof Texture.Checker c) {
            return (mean(c.colors().get(0).linear()) + mean(c.colors().get(1).linear())) / 2;
        }
        return mean((Texture.File) t.texture()) * mean(t.factor());
    }

    /** The number of a texture that must be one number here: its mean, with a note. */
    double mean(ResolvedTexture t, Place place, String what) {
        if (!t.isSolid()) {
            notes.add(place.shown(), what + " is a texture; its mean stands for it");
        }
        return mean(t);
    }

    static double mean(Rgb c) {
        return (c.r() + c.g() + c.b()) / 3;
    }

    private static double mean(Texture.File file) {
        try {
            Image image = ImageFiles.read(file.file());
            double sum = 0;
            for (int y = 0; y < image.height(); y++) {
                for (int x = 0; x < image.width(); x++) {
                    for (int c = 0; c < 3; c++) {
                        double v = image.component(x, y, c);
                        sum += file.encoding() == Texture.Encoding.SRGB ? TransferCurve.decode(v) : v;
                    }
                }
            }
            return sum / (3.0 * image.width() * image.height());
        } catch (IOException e) {
            return 0.5;
        }
    }
}
