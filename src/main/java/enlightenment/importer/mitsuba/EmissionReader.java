package enlightenment.importer.mitsuba;

import enlightenment.color.Color;
import enlightenment.color.Rgb;
import enlightenment.importer.support.UvMap;
import enlightenment.material.Texture;
import java.io.IOException;
import java.util.List;
import java.util.Optional;

/** Reads what shapes emit. */
final class EmissionReader {
    private final SceneIndex scene;

    EmissionReader(SceneIndex scene) {
        this.scene = scene;
    }

    /**
     * What a shape's area emitter emits; empty if it has none.
     *
     * @param surface what the shape is made of: the textures of one surface have one map of texture coordinates
     */
    Optional<AreaEmission> area(XmlElement shape, Surface surface) {
        List<XmlElement> found = scene.inside(shape, "emitter");
        if (found.isEmpty()) {
            return Optional.empty();
        }
        XmlElement e = found.get(0);
        if (!e.type().equals("area")) {
            scene.note(e, e.described() + " is left out");
            return Optional.empty();
        }
        Properties p = new Properties(e);
        AreaEmission emission = radiance(p, surface);
        p.ignore("sampling_weight", "id");
        scene.noteUnused(p);
        return emission.radiance().isBlack() ? Optional.empty() : Optional.of(emission);
    }

    private AreaEmission radiance(Properties p, Surface surface) {
        Optional<XmlElement> e = p.find("radiance").map(scene::resolved);
        if (e.isPresent() && e.get().tag().equals("texture")) {
            TextureReader textures = new TextureReader(scene);
            Texture texture = textures.texture(e.get(), false);
            if (texture instanceof Texture.Solid solid) {
                return even(solid.color().linear());
            }
            if (!surface.isTextured() || surface.map().equals(textures.map())) {
                return textured(e.get(), texture, textures.map());
            }
            scene.note(e.get(), "a radiance whose to_uv is not that of the surface's other textures becomes its mean");
        }
        return even(light(p, "radiance", 1));
    }

    private static AreaEmission even(Rgb radiance) {
        return new AreaEmission(radiance, Optional.empty(), UvMap.IDENTITY);
    }

    /** What files of floats and checkers hold may be above 1: they are divided by their largest component, or by 1 if that is more. */
    private AreaEmission textured(XmlElement e, Texture texture, UvMap uv) {
        if (texture instanceof Texture.Checker c) {
            double largest = StrictMath.max(
                    1,
                    c.colors().stream().mapToDouble(x -> x.linear().max()).max().orElse(1));
            List<Color> colors = c.colors().stream()
                    .<Color>map(x -> x.linear().times(Rgb.gray(1 / largest)))
                    .toList();
            return new AreaEmission(Rgb.gray(largest), Optional.of(new Texture.Checker(colors, c.scale())), uv);
        }
        Texture.File file = (Texture.File) texture;
        if (!TextureReader.isOfFloats(file.file())) {
            return new AreaEmission(Rgb.WHITE, Optional.of(file), uv);
        }
        try {
            DerivedPictures.Scaled scaled = scene.pictures().scaled(file);
            return new AreaEmission(Rgb.gray(scaled.brightest()), Optional.of(scaled.picture()), uv);
        } catch (IOException problem) {
            scene.note(e, "a texture is left out: " + problem.getMessage());
            return even(Rgb.gray(0.5));
        }
    }

    /** A property that is light: a colour or a spectrum, or the mean of a texture. */
    Rgb light(Properties p, String name, double otherwise) {
        Optional<XmlElement> e = p.find(name).map(scene::resolved);
        if (e.isEmpty()) {
            return Rgb.gray(otherwise);
        }
        return e.get().tag().equals("texture")
                ? new TextureReader(scene).mean(e.get())
                : new ColorValue(scene).light(e.get());
    }
}
