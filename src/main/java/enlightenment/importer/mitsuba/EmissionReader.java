package enlightenment.importer.mitsuba;

import enlightenment.color.Rgb;
import java.util.List;
import java.util.Optional;

/** Reads what shapes emit. */
final class EmissionReader {
    private final SceneIndex scene;

    EmissionReader(SceneIndex scene) {
        this.scene = scene;
    }

    /** The radiance of a shape's area emitter; empty if it has none. */
    Optional<Rgb> area(XmlElement shape) {
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
        Rgb radiance = light(p, "radiance", 1);
        p.ignore("sampling_weight", "id");
        scene.noteUnused(p);
        return radiance.equals(Rgb.BLACK) ? Optional.empty() : Optional.of(radiance);
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
