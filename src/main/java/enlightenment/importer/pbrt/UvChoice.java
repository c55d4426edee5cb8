package enlightenment.importer.pbrt;

import enlightenment.color.Color;
import enlightenment.color.Rgb;
import enlightenment.importer.support.ImportNotes;
import enlightenment.material.Texture;

/** The one map of texture coordinates that all textures of a material have: that of the first one that is no solid colour. */
final class UvChoice {
    private final Place place;
    private final ImportNotes notes;
    private UvMap map;

    UvChoice(Place place, ImportNotes notes) {
        this.place = place;
        this.notes = notes;
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

    /** The texture of a colour; a factor of an image is left out with a note. */
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
        if (!t.factor().equals(Rgb.WHITE)) {
            notes.add(place.shown(), "the scale of an image is left out");
        }
        return t.texture();
    }

    /** The texture of a share, 0..1. */
    Texture share(ResolvedTexture t) {
        return color(t);
    }
}
