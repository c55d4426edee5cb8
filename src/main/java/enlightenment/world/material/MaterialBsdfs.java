package enlightenment.world.material;

import enlightenment.bsdf.Bsdf;
import enlightenment.bsdf.Fresnel;
import enlightenment.bsdf.GlossyReflection;
import enlightenment.bsdf.Lambert;
import enlightenment.bsdf.Microfacets;
import enlightenment.bsdf.PrincipledLayers;
import enlightenment.bsdf.PrincipledReflection;
import enlightenment.bsdf.RoughCoating;
import enlightenment.bsdf.RoughDielectric;
import enlightenment.bsdf.RoughDiffuse;
import enlightenment.bsdf.SmoothCoating;
import enlightenment.bsdf.SmoothConductor;
import enlightenment.bsdf.SmoothDielectric;
import enlightenment.bsdf.SmoothRefraction;
import enlightenment.bsdf.SpecularReflection;
import enlightenment.material.Coated;
import enlightenment.material.Glass;
import enlightenment.material.Glossy;
import enlightenment.material.Material;
import enlightenment.material.Principled;
import enlightenment.material.Texture;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Supplier;

/**
 * The scattering functions of a scene's materials. Those with tables are made once for all materials that differ in colour alone, and
 * reused for the next scene. For use by one thread.
 */
public final class MaterialBsdfs {
    private final Map<List<Object>, Bsdf> made = new ConcurrentHashMap<>();

    /** The scattering functions of the scene before, which another thread may still be compiling. */
    private final Map<List<Object>, Bsdf> earlier;

    private final PrincipledLayers layers = new PrincipledLayers();

    public MaterialBsdfs() {
        this(Map.of());
    }

    private MaterialBsdfs(Map<List<Object>, Bsdf> earlier) {
        this.earlier = earlier;
    }

    /** For the next scene: reuses those of this one that it needs; the rest is dropped. */
    public MaterialBsdfs next() {
        return new MaterialBsdfs(made);
    }

    Bsdf of(Material material) {
        if (material instanceof Material.Matte matte) {
            return matte.roughness() == 0 ? Lambert.INSTANCE : new RoughDiffuse(matte.roughness());
        }
        if (material instanceof Glass glass) {
            return glass.smoothRefraction()
                    ? SmoothRefraction.INSTANCE
                    : roughInterface(glass.roughness(), glass.multipleScattering());
        }
        if (material instanceof Material.Fluorescent || !material.parts().isEmpty()) {
            return Lambert.INSTANCE;
        }
        if (material instanceof Material.Mirror) {
            return SpecularReflection.INSTANCE;
        }
        if (material instanceof Glossy g) {
            return g.roughness() instanceof Texture.Amount.Constant roughness
                    ? metal(roughness.value(), g.conductor(), g.multipleScattering())
                    : Lambert.INSTANCE;
        }
        if (material instanceof Coated c) {
            return c.roughness() instanceof Texture.Amount.Constant roughness
                    ? coating(roughness.value(), c.indexOfRefraction(), c.nonlinear())
                    : Lambert.INSTANCE;
        }
        if (material instanceof Principled p) {
            return p.metallic() instanceof Texture.Amount.Constant metallic
                            && p.roughness() instanceof Texture.Amount.Constant roughness
                            && p.clearcoat().roughness() instanceof Texture.Amount.Constant clear
                    ? principled(metallic.value(), roughness.value(), clear.value(), p)
                    : Lambert.INSTANCE;
        }
        if (material instanceof Material.Scattering scattering) {
            return roughInterface(Texture.Amount.of(scattering.roughness()), true);
        }
        throw new AssertionError("no physical form of the material " + material.type());
    }

    private Bsdf once(Supplier<Bsdf> maker, Object... key) {
        List<Object> all = List.of(key);
        Bsdf known = made.get(all);
        if (known == null) {
            Bsdf before = earlier.get(all);
            known = before == null ? maker.get() : before;
            made.put(all, known);
        }
        return known;
    }

    private Bsdf metal(double roughness, Optional<Glossy.Conductor> conductor, boolean losesNothing) {
        double alpha = roughness * roughness;
        Supplier<Fresnel> fresnel =
                () -> conductor.map(c -> Fresnel.conductor(c.eta(), c.k())).orElse(Fresnel.SCHLICK);
        return once(
                () -> Microfacets.isSmooth(alpha)
                        ? new SmoothConductor(fresnel.get())
                        : new GlossyReflection(alpha, fresnel.get(), losesNothing),
                "metal",
                alpha,
                conductor,
                losesNothing);
    }

    private Bsdf coating(double roughness, double index, boolean nonlinear) {
        if (index == 1) {
            return Lambert.INSTANCE;
        }
        double alpha = roughness * roughness;
        return once(
                () -> Microfacets.isSmooth(alpha)
                        ? new SmoothCoating(index, nonlinear)
                        : new RoughCoating(alpha, index, nonlinear),
                "coat",
                alpha,
                index,
                nonlinear);
    }

    private Bsdf principled(double metallic, double roughness, double clearRoughness, Principled p) {
        double index = index(p.indexOfRefraction(), p.specular());
        Principled.Sheen sheen = p.sheen();
        if (p.clearcoat().share() == 0 && metallic == 1) {
            return metal(roughness, Optional.empty(), true);
        }
        if (p.clearcoat().share() == 0 && metallic == 0 && sheen.share() == 0) {
            return coating(roughness, index, false);
        }
        double alpha = roughness * roughness;
        double clearAlpha = clearRoughness * clearRoughness;
        double share = p.clearcoat().share();
        return once(
                () -> new PrincipledReflection(
                        metallic,
                        alpha,
                        index,
                        share,
                        clearAlpha,
                        Coated.USUAL_INDEX,
                        sheen.share(),
                        sheen.tint(),
                        layers),
                "principled",
                metallic,
                alpha,
                index,
                share,
                clearAlpha,
                sheen);
    }

    /**
     * The index of refraction, at least 1, whose reflectance at normal incidence, ((n − 1)/(n + 1))², is that of another times a factor.
     */
    static double index(double of, double factor) {
        double root = Math.sqrt(factor) * ((of - 1) / (of + 1));
        return factor == 1 ? of : (1 + root) / (1 - root);
    }

    /**
     * The scattering function of a rough interface; for a textured roughness, one that stands for those of all its levels where no position
     * is given.
     */
    private Bsdf roughInterface(Texture.Amount roughness, boolean losesNothing) {
        double value = roughness instanceof Texture.Amount.Constant constant ? constant.value() : 1;
        double alpha = value * value;
        return Microfacets.isSmooth(alpha)
                ? SmoothDielectric.INSTANCE
                : once(() -> new RoughDielectric(alpha, losesNothing), "rough interface", alpha, losesNothing);
    }
}
