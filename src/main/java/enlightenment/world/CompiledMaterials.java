package enlightenment.world;

import enlightenment.frame.SceneFrame;
import enlightenment.material.Coated;
import enlightenment.material.Composite;
import enlightenment.material.Glass;
import enlightenment.material.Glossy;
import enlightenment.material.Material;
import enlightenment.material.Principled;
import enlightenment.material.Texture;
import enlightenment.scene.Scene;
import enlightenment.scene.SceneObject;
import enlightenment.texture.ImageTexture;
import enlightenment.world.light.SceneImages;
import enlightenment.world.material.AmountLookup;
import enlightenment.world.material.Dyes;
import enlightenment.world.material.MaterialBsdfs;
import enlightenment.world.material.PhysicalSurface;
import enlightenment.world.material.RadianceMap;
import enlightenment.world.material.RoughnessLevels;
import enlightenment.world.material.SurfaceDetail;
import enlightenment.world.material.SurfaceMaterial;
import enlightenment.world.material.TextureLookup;
import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;

/** The materials of a scene's objects as rendering reads them, with their images. */
final class CompiledMaterials {
    /** By identity of the description: a material used many times is one object, and comparing records by value slows down start-up. */
    final Map<Material, SurfaceMaterial> bySource = new IdentityHashMap<>();

    /** Makes the detail of a material with several levels of one of its roughnesses. */
    private interface LevelsDetail {
        SurfaceDetail of(RoughnessLevels levels, List<SurfaceMaterial> parts, AmountLookup roughness);
    }

    private final Scene scene;
    private final SceneFrame physical;
    private final SceneImages images;
    private final Runnable poll;
    private final Dyes dyes;
    private final MaterialBsdfs bsdfs;

    /**
     * @param physical the frame if the shading is physical, else null
     */
    CompiledMaterials(Scene scene, SceneFrame physical, SceneImages images, Runnable poll) {
        this.scene = scene;
        this.physical = physical;
        this.images = images;
        this.poll = poll;
        dyes = new Dyes(scene);
        bsdfs = images.bsdfs();
        for (SceneObject o : scene.objects()) {
            if (o.faces().isEmpty()) {
                add(o.material());
            }
            o.faces().forEach(this::add);
        }
    }

    private SurfaceMaterial add(Material m) {
        SurfaceMaterial known = bySource.get(m);
        if (known != null) {
            return known;
        }
        PhysicalSurface surface = physical == null ? null : PhysicalSurface.of(m, physical, dyes, bsdfs);
        SurfaceMaterial made =
                new SurfaceMaterial(m, image(m.color()), surface, detail(m), radianceMap(m), opaqueShare(m));
        bySource.put(m, made);
        return made;
    }

    /**
     * The material of partly transparent glass where it is opaque; null if it is opaque nowhere, and in classic shading, where such glass
     * is matte.
     */
    private SurfaceMaterial opaqueShare(Material m) {
        return physical != null && m instanceof Glass glass && glass.transparency() < 1
                ? add(glass.opaque().orElseGet(() -> Material.Matte.of(glass.color())))
                : null;
    }

    /** The texture of a material's emission; null without one. A single colour is part of the radiance instead. */
    private RadianceMap radianceMap(Material m) {
        return physical == null || m.radianceMap().isEmpty() || m.radianceMap().get() instanceof Texture.Solid
                ? null
                : new RadianceMap(lookup(m.radianceMap().get()));
    }

    private ImageTexture image(Texture texture) {
        if (!(texture instanceof Texture.File file)) {
            return null;
        }
        // Checks for cancellation between images, so not for a single one.
        if (images.haveBeenRead()) {
            poll.run();
        }
        return images.of(file, physical != null, scene);
    }

    private TextureLookup lookup(Texture texture) {
        return new TextureLookup(texture, image(texture), true);
    }

    private AmountLookup lookup(Texture.Amount amount) {
        return amount instanceof Texture.Amount.Textured t
                ? new AmountLookup(lookup(t.texture()), t.channel(), t.factor())
                : AmountLookup.of((Texture.Amount.Constant) amount);
    }

    /**
     * The detail of a material whose roughness is textured: one part for each of some roughness levels; null if the roughness is constant.
     */
    private SurfaceDetail ofRoughness(Texture.Amount roughness, Function<Texture.Amount, Material> with) {
        return ofLevels(roughness, with, SurfaceDetail::ofRoughness);
    }

    private SurfaceDetail ofLevels(
            Texture.Amount roughness, Function<Texture.Amount, Material> with, LevelsDetail detail) {
        if (roughness instanceof Texture.Amount.Constant) {
            return null;
        }
        AmountLookup amount = lookup(roughness);
        RoughnessLevels levels = RoughnessLevels.of(amount);
        List<SurfaceMaterial> parts = new ArrayList<>();
        for (double level : levels.all()) {
            poll.run();
            parts.add(add(with.apply(Texture.Amount.of(level))));
        }
        return detail.of(levels, parts, amount);
    }

    /** The detail of a textured metallic share: each point is metal or not, with that probability. */
    private SurfaceDetail ofPrincipled(Principled m) {
        if (m.metallic() instanceof Texture.Amount.Textured) {
            return SurfaceDetail.mix(
                    add(m.withMetallic(Texture.Amount.of(0))),
                    add(m.withMetallic(Texture.Amount.of(1))),
                    lookup(m.metallic()));
        }
        if (m.roughness() instanceof Texture.Amount.Textured) {
            return ofRoughness(m.roughness(), m::withRoughness);
        }
        return ofLevels(
                m.clearcoat().roughness(),
                value -> m.withClearcoat(m.clearcoat().withRoughness(value)),
                SurfaceDetail::ofClearcoatRoughness);
    }

    /** The detail that decides what a material is at a point; null for most materials. */
    private SurfaceDetail detail(Material m) {
        if (m instanceof Composite.Mix mix) {
            return SurfaceDetail.mix(add(mix.first()), add(mix.second()), lookup(mix.weight()));
        } else if (m instanceof Composite.Mask mask) {
            return SurfaceDetail.mask(add(mask.of()), lookup(mask.map()));
        } else if (m instanceof Composite.NormalMap normals) {
            return SurfaceDetail.normalMap(add(normals.of()), lookup(normals.map()));
        } else if (m instanceof Composite.Bump bump) {
            return SurfaceDetail.bump(add(bump.of()), lookup(bump.map()), physical.toFrame(bump.height()));
        } else if (physical == null) {
            return null;
        } else if (m instanceof Glossy glossy) {
            return ofRoughness(glossy.roughness(), glossy::withRoughness);
        } else if (m instanceof Coated coated) {
            return ofRoughness(coated.roughness(), coated::withRoughness);
        } else if (m instanceof Glass glass) {
            return ofRoughness(glass.roughness(), glass::withRoughness);
        } else if (m instanceof Principled principled) {
            return ofPrincipled(principled);
        }
        return null;
    }
}
