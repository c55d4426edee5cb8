package enlightenment.importer.pbrt;

import enlightenment.color.Rgb;
import enlightenment.geometry.Shape;
import enlightenment.importer.support.Affine;
import enlightenment.importer.support.Fillings;
import enlightenment.importer.support.ImportDraft;
import enlightenment.material.Composite;
import enlightenment.material.Glass;
import enlightenment.material.Material;
import enlightenment.material.Medium;
import enlightenment.material.Texture;
import java.util.IdentityHashMap;
import java.util.Map;
import java.util.Optional;

/** Makes objects of shapes with their materials, media and opacity. */
final class Assembly {
    private final Materials materials;
    private final Textures textures;
    private final Media media;
    private final PlacedForms forms;
    private final GlowingShapes lamps;
    private final ImportDraft draft;
    private final Map<ShapeDefinition, Prepared> prepared = new IdentityHashMap<>();

    /** What a definition becomes, before it is placed: instances share it. */
    private record Prepared(
            Form form, Surface surface, Optional<Medium.Coefficients> medium, Optional<LampPicture> lamp) {}

    Assembly(Materials materials, Textures textures, Media media, GlowingShapes lamps, ImportDraft draft) {
        this.materials = materials;
        this.textures = textures;
        this.media = media;
        this.lamps = lamps;
        this.draft = draft;
        forms = new PlacedForms(draft.notes());
    }

    private void note(ShapeDefinition shape, String message) {
        draft.notes().add(shape.parameters().place().shown(), message);
    }

    void add(ShapeDefinition shape, Affine map) {
        Place place = shape.parameters().place();
        try {
            Prepared p = prepared.computeIfAbsent(shape, this::prepare);
            boolean isLamp = shape.areaLight() != null;
            if (p.surface().isInterface() && p.medium().isEmpty() && !isLamp) {
                return;
            }
            Shape placed = whole(shape, p, forms.place(p.form(), map, place));
            Surface surface = fitted(shape, p, placed.enclosesVolume());
            if (isLamp) {
                lamps.add(shape, p.form(), map, placed, surface, p.lamp());
            } else if (!surface.isInterface()) {
                draft.object("", placed, surface.material());
            }
        } catch (IllegalArgumentException e) {
            throw place.failure(e.getMessage());
        }
    }

    /** The shape, without holes where glass or a medium fills it. */
    private Shape whole(ShapeDefinition shape, Prepared p, Shape placed) {
        Surface surface = p.surface();
        boolean isFilled = surface.isInterface()
                ? p.medium().isPresent()
                : surface.material() instanceof Material.Scattering
                        || surface.material() instanceof Glass && !surface.isThinGlass();
        return isFilled
                ? Fillings.whole(
                        placed, draft.notes(), shape.parameters().place().shown())
                : placed;
    }

    private Prepared prepare(ShapeDefinition shape) {
        Surface surface = cutOut(shape, materials.resolve(shape.material()));
        Optional<LampPicture> lamp = lamps.picture(shape.areaLight(), surface);
        boolean isTextured =
                surface.isTextured() || lamp.flatMap(LampPicture::texture).isPresent();
        Form form = isTextured ? PlacedForms.textured(shape.form(), surface.uv()) : shape.form();
        Place place = shape.parameters().place();
        return new Prepared(form, surface, media.find(shape.insideMedium(), place), lamp);
    }

    private Surface cutOut(ShapeDefinition shape, Surface surface) {
        Parameters p = shape.parameters();
        if (!p.has("alpha") || surface.isInterface()) {
            return surface;
        }
        ResolvedTexture alpha = textures.number(p, "alpha", 1);
        if (alpha.isSolid() && alpha.color().max() >= 1) {
            return surface;
        }
        Material m = surface.material();
        if (m instanceof Glass || m instanceof Material.Scattering) {
            note(shape, "the opacity of what is not opaque is left out");
            return surface;
        }
        UvChoice uv = textures.uvChoice(p.place());
        if (surface.isTextured()) {
            uv.take(surface.uv());
        }
        Texture share = uv.share(alpha);
        return new Surface(new Composite.Mask(m, share), uv.chosen(), false);
    }

    /** The surface as it can stand on a shape that encloses a volume, or does not. */
    private Surface fitted(ShapeDefinition shape, Prepared p, boolean isSolid) {
        Surface surface = p.surface();
        if (surface.isInterface()) {
            if (!isSolid) {
                note(shape, "a medium in a shape that encloses no volume is left out");
                return surface;
            }
            return p.medium().isEmpty()
                    ? surface
                    : Surface.of(Material.Scattering.of(p.medium().get()));
        } else if (surface.material() instanceof Glass glass) {
            return surface.with(isSolid ? filled(shape, surface, glass, p.medium()) : pane(shape, surface, glass));
        } else if (surface.material() instanceof Material.Scattering && !isSolid) {
            note(shape, "what scatters below its surface encloses no volume; it becomes matte");
            return surface.with(Material.Matte.of(Texture.of(Rgb.gray(0.8))));
        }
        return surface;
    }

    private Material filled(ShapeDefinition shape, Surface surface, Glass glass, Optional<Medium.Coefficients> medium) {
        if (surface.isThinGlass()) {
            note(shape, "thin glass around a volume reflects nothing");
            return Glass.of(Texture.of(Rgb.WHITE), 1);
        }
        if (medium.isEmpty()) {
            return glass;
        }
        return Fillings.filled(
                glass, medium.get(), draft.notes(), shape.parameters().place().shown());
    }

    private Material pane(ShapeDefinition shape, Surface surface, Glass glass) {
        if (!surface.isThinGlass()) {
            note(shape, "glass that encloses no volume becomes a thin pane");
        }
        return glass.withRoughness(0);
    }
}
