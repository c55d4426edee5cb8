package enlightenment.importer.mitsuba;

import enlightenment.color.Rgb;
import enlightenment.material.Medium;
import java.util.List;
import java.util.Optional;

/** The media that fill shapes: homogeneous ones, by their extinction and albedo, of Mitsuba 0.6 by scattering and absorption, too. */
final class MediumReader {
    private final SceneIndex scene;
    private final ColorValue colors;

    MediumReader(SceneIndex scene) {
        this.scene = scene;
        colors = new ColorValue(scene);
    }

    /** The medium inside of a shape; empty, with a note where that loses something, for none or one that varies. */
    Optional<Medium.Coefficients> interior(XmlElement shape) {
        Optional<Medium.Coefficients> found = Optional.empty();
        for (XmlElement child : shape.children()) {
            boolean isMedium = child.tag().equals("medium")
                    || child.tag().equals("ref") && scene.resolved(child).tag().equals("medium");
            if (isMedium && child.name().equals("exterior")) {
                scene.note(shape, "the medium outside of a shape is left out");
            } else if (isMedium) {
                found = medium(scene.resolved(child));
            }
        }
        return found;
    }

    private Optional<Medium.Coefficients> medium(XmlElement e) {
        Properties p = new Properties(e);
        boolean isEven = e.children().stream()
                .noneMatch(c -> c.tag().equals("volume") && !c.type().equals("constvolume"));
        if (!e.type().equals("homogeneous") || !isEven) {
            scene.note(e, e.described() + " is left out: only media that are the same everywhere are read");
            return Optional.empty();
        }
        p.ignore("id", "has_spectral_extinction", "sample_emitters");
        Rgb scale = Rgb.gray(StrictMath.max(p.number("scale", 1), 0));
        boolean isSplit = p.has("sigma_s") || p.has("sigma_a");
        Rgb scattering;
        Rgb absorption;
        if (isSplit) {
            scattering = value(p, "sigma_s", 0);
            absorption = value(p, "sigma_a", 0);
        } else {
            Rgb extinction = value(p, "sigma_t", 1);
            Rgb albedo = value(p, "albedo", 0.75);
            Rgb share = new Rgb(
                    StrictMath.min(albedo.r(), 1), StrictMath.min(albedo.g(), 1), StrictMath.min(albedo.b(), 1));
            scattering = extinction.times(share);
            absorption = extinction.times(new Rgb(1 - share.r(), 1 - share.g(), 1 - share.b()));
        }
        double anisotropy = anisotropy(e);
        scene.noteUnused(p);
        return Optional.of(new Medium.Coefficients(scattering.times(scale), absorption.times(scale), anisotropy));
    }

    private Rgb value(Properties p, String name, double otherwise) {
        Optional<XmlElement> e = p.find(name).map(scene::resolved);
        if (e.isPresent() && e.get().tag().equals("volume")) {
            return value(new Properties(e.get()), "value", otherwise);
        }
        return e.map(colors::factor).orElse(Rgb.gray(otherwise));
    }

    private double anisotropy(XmlElement medium) {
        List<XmlElement> phases = scene.inside(medium, "phase");
        if (phases.isEmpty() || phases.get(0).type().equals("isotropic")) {
            return 0;
        }
        XmlElement phase = phases.get(0);
        if (!phase.type().equals("hg")) {
            scene.note(phase, phase.described() + " is left out: the medium scatters to all sides alike");
            return 0;
        }
        return new Properties(phase).number("g", 0.8);
    }
}
