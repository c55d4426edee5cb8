package enlightenment.importer.pbrt;

import enlightenment.color.Rgb;
import enlightenment.importer.support.ImportNotes;
import enlightenment.material.Composite;
import enlightenment.material.Glass;
import enlightenment.material.Material;
import enlightenment.material.Texture;
import enlightenment.text.Plain;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** The named materials of a scene, and what materials become. */
final class Materials {
    /** Mixed materials may hold mixed materials. */
    private static final int DEEPEST = 16;

    private final Map<String, MaterialSource> named = new LinkedHashMap<>();
    private final Map<MaterialSource, Surface> resolved = new IdentityHashMap<>();
    private final Map<String, SurfaceMaker> makers = new HashMap<>();
    private final Textures textures;
    private final ImportNotes notes;

    /** Makes a surface of the parameters of one kind of material. */
    interface SurfaceMaker {
        /** @param uv where the map of texture coordinates is left */
        Material make(MaterialSource source, UvChoice uv);
    }

    Materials(Textures textures, Spectra spectra, ImportNotes notes) {
        this.textures = textures;
        this.notes = notes;
        new OpaqueMaterials(textures, spectra, notes).addTo(makers);
        new ClearMaterials(textures, spectra, notes).addTo(makers);
    }

    void define(String name, MaterialSource source) {
        named.put(name, source);
    }

    /** The named materials that shapes have, in their order, with what they became. */
    Map<String, Surface> used() {
        Map<String, Surface> used = new LinkedHashMap<>();
        named.forEach((name, source) -> {
            if (resolved.containsKey(source)) {
                used.put(name, resolved.get(source));
            }
        });
        return used;
    }

    /** What a material becomes. */
    Surface resolve(MaterialSource source) {
        return resolve(source, 0);
    }

    private Surface resolve(MaterialSource source, int depth) {
        Surface known = resolved.get(source);
        if (known == null) {
            known = source.name().isEmpty() ? made(source, depth) : resolve(definition(source), depth);
            resolved.put(source, known);
        }
        return known;
    }

    private MaterialSource definition(MaterialSource reference) {
        MaterialSource source = named.get(reference.name());
        if (source == null) {
            throw reference
                    .parameters()
                    .place()
                    .failure("there is no material named " + Plain.quoted(reference.name()));
        }
        return source;
    }

    private Surface made(MaterialSource source, int depth) {
        if (source.type().equals("mix")) {
            return mixed(source, depth);
        }
        if (source.type().equals("interface")
                || source.type().isEmpty()
                || source.type().equals("none")) {
            return Surface.INTERFACE;
        }
        SurfaceMaker maker = makers.get(source.type());
        Place place = source.parameters().place();
        if (maker == null) {
            throw place.failure("pbrt-v4 has no material of the kind " + Plain.quoted(source.type())
                    + "; files of pbrt-v3 are converted by \"pbrt --upgrade\"");
        }
        UvChoice uv = textures.uvChoice(place);
        Material material = maker.make(source, uv);
        material = relief(source, material, uv);
        return new Surface(material, uv.chosen(), source.type().equals("thindielectric"));
    }

    private Surface mixed(MaterialSource source, int depth) {
        Parameters p = source.parameters();
        List<String> names = p.strings("materials");
        if (names.size() != 2 || depth > DEEPEST) {
            throw p.place()
                    .failure(
                            depth > DEEPEST
                                    ? "materials are mixed in a circle, or too deep"
                                    : "a mixed material must have two names in \"string materials\"");
        }
        Surface first = resolve(MaterialSource.named(names.get(0), p.place()), depth + 1);
        Surface second = resolve(MaterialSource.named(names.get(1), p.place()), depth + 1);
        ResolvedTexture amount = textures.number(p, "amount", 0.5);
        if (isMixable(first) && isMixable(second)) {
            UvChoice uv = textures.uvChoice(p.place());
            if (first.isTextured()) {
                uv.take(first.uv());
            }
            if (second.isTextured()) {
                uv.take(second.uv());
            }
            return new Surface(
                    new Composite.Mix(first.material(), second.material(), uv.share(amount)), uv.chosen(), false);
        }
        notes.add(p.place().shown(), "of a mixed material that is not opaque the part with more weight stays");
        return textures.mean(amount, p.place(), "the amount of a mixed material") > 0.5 ? second : first;
    }

    private static boolean isMixable(Surface s) {
        return !s.isInterface() && !(s.material() instanceof Glass) && !(s.material() instanceof Material.Scattering);
    }

    private Material relief(MaterialSource source, Material material, UvChoice uv) {
        Parameters p = source.parameters();
        if (!p.has("normalmap") && !p.has("displacement")) {
            return material;
        }
        if (!isMixable(Surface.of(material))) {
            notes.add(p.place().shown(), "the relief of what is not opaque is left out");
            return material;
        }
        if (p.has("normalmap")) {
            return new Composite.NormalMap(
                    material,
                    textures.linearImage(
                            p.string("normalmap", ""),
                            p.find("normalmap").orElseThrow().place()));
        }
        ResolvedTexture height = textures.number(p, "displacement", 0);
        if (height.texture() instanceof Texture.File file) {
            uv.take(height.uv());
            Rgb factor = height.factor();
            return new Composite.Bump(material, file, factor.r());
        }
        if (!height.isSolid()) {
            notes.add(p.place().shown(), "a displacement that is no image is left out");
        }
        return material;
    }
}
