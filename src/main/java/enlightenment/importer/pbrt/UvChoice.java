package enlightenment.importer.pbrt;

import enlightenment.color.Color;
import enlightenment.color.Rgb;
import enlightenment.importer.support.ImportNotes;
import enlightenment.importer.support.UvMap;
import enlightenment.material.Texture;
import java.util.function.DoubleUnaryOperator;

/** The one map of texture coordinates that all textures of a material have: that of the first one that is no solid colour. */
final class UvChoice {
    private final Place place;
    private final ImportNotes notes;
    private final DerivedPictures pictures;
    private UvMap map;

    UvChoice(Place place, ImportNotes notes, DerivedPictures pictures) {
        this.place = place;
        this.notes = notes;
        this.pictures = pictures;
    }

    UvMap chosen() {
        return map == null ? UvMap.IDENTITY : map;
    }

    void take(UvMap other) {
        if (map != null && !map.equals(other)) {
            notes.add(place.shown(), "textures of one material have different scales; that of the first one counts");
        } else {
            map = other;
        }
    }

    /** The texture of a colour; an image with a factor is made anew. */
    Texture color(ResolvedTexture t) {
        if (t.isSolid()) {
            return Texture.of(Textures.clamped(t.color()));
        }
        take(t.uv());
        if (!t.factor().equals(Rgb.WHITE) && t.texture() instanceof Texture.Checker c) {
            return new Texture.Checker(
                    c.colors().stream()
                            .<Color>map(x -> Textures.clamped(x.linear().times(t.factor())))
                            .toList(),
                    c.scale());
        }
        if (!t.factor().equals(Rgb.WHITE) && t.texture() instanceof Texture.File file) {
            return pictures.of(file, "times " + t.factor(), rgb -> scale(rgb, t.factor()), place);
        }
        return t.texture();
    }

    private static void scale(double[] rgb, Rgb factor) {
        rgb[0] *= factor.r();
        rgb[1] *= factor.g();
        rgb[2] *= factor.b();
    }

    /** The texture of a number, 0..1, of which each place has another one. */
    Texture number(ResolvedTexture t, String what, DoubleUnaryOperator change) {
        take(t.uv());
        if (t.texture() instanceof Texture.Checker c) {
            return new Texture.Checker(
                    c.colors().stream()
                            .<Color>map(x -> Rgb.gray(change.applyAsDouble(
                                    Textures.mean(x.linear().times(t.factor())))))
                            .toList(),
                    c.scale());
        }
        return pictures.of(
                (Texture.File) t.texture(),
                what + " times " + t.factor(),
                rgb -> {
                    scale(rgb, t.factor());
                    double v = change.applyAsDouble((rgb[0] + rgb[1] + rgb[2]) / 3);
                    rgb[0] = rgb[1] = rgb[2] = v;
                },
                place);
    }

    /** The texture of a share, 0..1. */
    Texture share(ResolvedTexture t) {
        return color(t);
    }
}
