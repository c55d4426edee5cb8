package enlightenment.importer.pbrt;

import enlightenment.color.Rgb;
import enlightenment.importer.support.ImportNotes;
import enlightenment.material.Medium;
import enlightenment.text.Plain;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;

/** The named media of a scene. */
final class Media {
    private final Map<String, MaterialSource> named = new HashMap<>();
    private final Spectra spectra;
    private final ImportNotes notes;

    Media(Spectra spectra, ImportNotes notes) {
        this.spectra = spectra;
        this.notes = notes;
    }

    /** Keeps a medium, whose parameters say its type. */
    void define(String name, Parameters parameters, ColorSpace space) {
        named.put(name, new MaterialSource(parameters.string("type", ""), name, parameters, space));
    }

    /** The medium of a name; empty for the empty name, which is a vacuum, and with a note for one that is not the same everywhere. */
    Optional<Medium.Coefficients> find(String name, Place place) {
        if (name.isEmpty()) {
            return Optional.empty();
        }
        MaterialSource source = named.get(name);
        if (source == null) {
            throw place.failure("there is no medium named " + Plain.quoted(name));
        }
        Parameters p = source.parameters();
        if (!source.type().equals("homogeneous")) {
            notes.add(p.place().shown(), "a medium of the kind " + Plain.quoted(source.type()) + " is left out");
            return Optional.empty();
        }
        if (p.has("preset")) {
            notes.add(p.place().shown(), "a medium's preset is left out; sigma_a and sigma_s count");
        }
        if (p.has("Le")) {
            notes.add(p.place().shown(), "the glow of a medium is left out");
        }
        Rgb scale = Rgb.gray(Math.max(0, p.number("scale", 1)));
        return Optional.of(new Medium.Coefficients(
                coefficient(source, "sigma_s").times(scale),
                coefficient(source, "sigma_a").times(scale),
                p.number("g", 0)));
    }

    private Rgb coefficient(MaterialSource source, String name) {
        return spectra.rgb(source.parameters(), name, Spectra.Kind.UNBOUNDED, source.space(), Rgb.WHITE);
    }
}
