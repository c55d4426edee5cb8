package enlightenment.world.material;

import enlightenment.bsdf.Bsdf;
import enlightenment.bsdf.Fresnel;
import enlightenment.bsdf.GlossyReflection;
import enlightenment.bsdf.Lambert;
import enlightenment.bsdf.Microfacets;
import enlightenment.bsdf.Reradiation;
import enlightenment.bsdf.RoughCoating;
import enlightenment.bsdf.RoughDielectric;
import enlightenment.bsdf.RoughDiffuse;
import enlightenment.bsdf.SmoothCoating;
import enlightenment.bsdf.SmoothConductor;
import enlightenment.bsdf.SmoothDielectric;
import enlightenment.bsdf.SpecularReflection;
import enlightenment.color.CauchyFormula;
import enlightenment.color.Rgb;
import enlightenment.frame.SceneFrame;
import enlightenment.material.Material;
import enlightenment.numeric.Scale;

/**
 * What physical shading knows of a material beyond its colour.
 *
 * @param bsdf how it scatters light
 * @param glow the radiance that it emits
 * @param glowsInside whether it emits from the inside as well
 * @param absorption how much of light a solid of it takes away on a straight way, per unit of length of the frame
 * @param dispersion how much its index of refraction grows with the place of the wavelength
 * @param ultraviolet the radiance of ultraviolet that it emits
 * @param reradiation what a dye in it does; null if there is none
 * @param medium what fills a solid of it if that scatters light; else null
 * @param look all this as a text that is equal for materials that look the same
 */
public record PhysicalSurface(
        Bsdf bsdf,
        Rgb glow,
        boolean glowsInside,
        Rgb absorption,
        double dispersion,
        double ultraviolet,
        Reradiation reradiation,
        HomogeneousMedium medium,
        String look) {
    /** That of a material of classic shading. */
    static final PhysicalSurface NONE = new PhysicalSurface(null, Rgb.BLACK, false, Rgb.BLACK, 0, 0, null, null, "");

    public static PhysicalSurface of(Material material, SceneFrame frame, Dyes dyes) {
        Rgb absorption = Rgb.BLACK;
        double dispersion = 0;
        Reradiation reradiation = null;
        HomogeneousMedium medium = null;
        String look = text(material.radiance(), material.ultraviolet());
        if (material instanceof Material.Glass glass) {
            absorption = scaled(glass.absorption(), frame.exponent());
            look += " " + glass.roughness() + " " + text(glass.absorption()) + " " + glass.multipleScattering();
            if (glass.dispersion().isPresent()) {
                dispersion = CauchyFormula.slope(
                        glass.indexOfRefraction(), glass.dispersion().getAsDouble());
                look += " " + dispersion;
            }
        } else if (material instanceof Material.Scattering scattering) {
            medium = HomogeneousMedium.of(scattering.medium(), frame);
            absorption = medium.extinction();
            look += " " + scattering.roughness() + " " + medium.look();
            medium = medium.scatters() ? medium : null;
        } else if (material instanceof Material.Matte matte) {
            look += " " + matte.roughness();
        } else if (material instanceof Material.Glossy glossy) {
            look += " " + glossy.roughness() + " " + glossy.conductor() + " " + glossy.multipleScattering();
        } else if (material instanceof Material.Coated coated) {
            look += " " + coated.roughness() + " " + coated.indexOfRefraction() + " " + coated.nonlinear();
        } else if (material instanceof Material.Fluorescent dye) {
            reradiation = dyes.of(dye);
            look += " " + dye.absorption() + " " + dye.emission() + " " + dye.yield();
        }
        return new PhysicalSurface(
                bsdf(material),
                material.radiance(),
                true,
                absorption,
                dispersion,
                material.ultraviolet(),
                reradiation,
                medium,
                look);
    }

    /** The surface of a light: black, and opaque. */
    public static PhysicalSurface light(Rgb radiance, double ultraviolet, boolean isTwoSided) {
        String look = text(radiance, ultraviolet) + " " + isTwoSided;
        return new PhysicalSurface(Lambert.INSTANCE, radiance, isTwoSided, Rgb.BLACK, 0, ultraviolet, null, null, look);
    }

    /** A record's own text takes as long as compiling a small scene, when a program has just started. */
    private static String text(Rgb c) {
        return c.r() + "," + c.g() + "," + c.b();
    }

    private static String text(Rgb c, double ultraviolet) {
        return ultraviolet == 0 ? text(c) : text(c) + "," + ultraviolet;
    }

    private static Bsdf bsdf(Material material) {
        if (material instanceof Material.Matte matte) {
            return matte.roughness() == 0 ? Lambert.INSTANCE : new RoughDiffuse(matte.roughness());
        }
        if (material instanceof Material.Fluorescent || !material.parts().isEmpty()) {
            return Lambert.INSTANCE;
        }
        if (material instanceof Material.Mirror) {
            return SpecularReflection.INSTANCE;
        }
        if (material instanceof Material.Glossy glossy) {
            double alpha = glossy.roughness() * glossy.roughness();
            Fresnel fresnel = glossy.conductor()
                    .map(c -> Fresnel.conductor(c.eta(), c.k()))
                    .orElse(Fresnel.SCHLICK);
            return Microfacets.isSmooth(alpha)
                    ? new SmoothConductor(fresnel)
                    : new GlossyReflection(alpha, fresnel, glossy.multipleScattering());
        }
        if (material instanceof Material.Coated coated) {
            return coating(coated);
        }
        if (material instanceof Material.Glass glass) {
            return border(glass.roughness(), glass.multipleScattering());
        }
        if (material instanceof Material.Scattering scattering) {
            return border(scattering.roughness(), true);
        }
        throw new AssertionError("no physical form of the material " + material.type());
    }

    private static Bsdf coating(Material.Coated coated) {
        double index = coated.indexOfRefraction();
        if (index == 1) {
            return Lambert.INSTANCE;
        }
        double alpha = coated.roughness() * coated.roughness();
        return Microfacets.isSmooth(alpha)
                ? new SmoothCoating(index, coated.nonlinear())
                : new RoughCoating(alpha, index, coated.nonlinear());
    }

    private static Bsdf border(double roughness, boolean losesNothing) {
        double alpha = roughness * roughness;
        return Microfacets.isSmooth(alpha) ? SmoothDielectric.INSTANCE : new RoughDielectric(alpha, losesNothing);
    }

    private static Rgb scaled(Rgb c, int exponent) {
        return new Rgb(scaled(c.r(), exponent), scaled(c.g(), exponent), scaled(c.b(), exponent));
    }

    /** Nothing is darker than what absorbs all light on the shortest way. */
    private static double scaled(double absorption, int exponent) {
        return Math.min(Scale.scalb(absorption, exponent), Double.MAX_VALUE);
    }
}
