package enlightenment.world.material;

import enlightenment.bsdf.Bsdf;
import enlightenment.bsdf.Lambert;
import enlightenment.bsdf.Reradiation;
import enlightenment.color.Rgb;
import enlightenment.colorimetry.CauchyFormula;
import enlightenment.frame.SceneFrame;
import enlightenment.material.Coated;
import enlightenment.material.Glass;
import enlightenment.material.Glossy;
import enlightenment.material.Material;
import enlightenment.material.Principled;
import enlightenment.material.Texture;
import enlightenment.numeric.Scale;

/**
 * The properties of a material in physical shading, beyond its colour.
 *
 * @param bsdf the scattering function
 * @param glow the emitted radiance
 * @param sides the sides that emit
 * @param absorption the extinction coefficient inside a solid of it, per unit of length of the frame
 * @param dispersion the slope of its index of refraction by wavelength ({@link enlightenment.colorimetry.CauchyFormula#slope})
 * @param ultraviolet the emitted radiance of ultraviolet
 * @param reradiation of a dye in it; null if there is none
 * @param medium that fills a solid of it, if that scatters light; else null
 * @param described the part of {@link #look()} that comes from the description; null for a light
 */
public record PhysicalSurface(
        Bsdf bsdf,
        Rgb glow,
        Material.EmissionPattern.Side sides,
        Rgb absorption,
        double dispersion,
        double ultraviolet,
        Reradiation reradiation,
        HomogeneousMedium medium,
        Look described) {
    /** The properties of a material of classic shading: none. */
    static final PhysicalSurface NONE = new PhysicalSurface(
            null, Rgb.BLACK, Material.EmissionPattern.Side.FRONT, Rgb.BLACK, 0, 0, null, null, null);

    /**
     * @param bsdfs makes the scattering function
     */
    public static PhysicalSurface of(Material material, SceneFrame frame, Dyes dyes, MaterialBsdfs bsdfs) {
        Rgb factor = material.radianceMap().orElse(null) instanceof Texture.Solid solid
                ? solid.color().linear()
                : Rgb.WHITE;
        Rgb glow = material.radiance().times(factor);
        double ultraviolet = material.ultraviolet() * factor.b();
        Rgb absorption = Rgb.BLACK;
        double dispersion = 0;
        Reradiation reradiation = null;
        HomogeneousMedium filling = null;
        if (material instanceof Glass glass) {
            absorption = scaled(glass.absorption(), frame.exponent());
            dispersion = glass.dispersion().isPresent()
                    ? CauchyFormula.slope(
                            glass.indexOfRefraction(), glass.dispersion().getAsDouble())
                    : 0;
        } else if (material instanceof Material.Scattering scattering) {
            filling = HomogeneousMedium.of(scattering.medium(), frame);
            absorption = filling.extinction();
        } else if (material instanceof Material.Fluorescent dye) {
            reradiation = dyes.of(dye);
        }
        String look = filling == null ? null : filling.look();
        return new PhysicalSurface(
                bsdfs.of(material),
                glow,
                material.pattern().side(),
                absorption,
                dispersion,
                ultraviolet,
                reradiation,
                filling == null || !filling.scatters() ? null : filling,
                new Look(material, look));
    }

    /** The surface of a light: black, and opaque. */
    public static PhysicalSurface light(Rgb radiance, double ultraviolet, boolean isTwoSided) {
        Material.EmissionPattern.Side sides =
                isTwoSided ? Material.EmissionPattern.Side.BOTH : Material.EmissionPattern.Side.FRONT;
        return new PhysicalSurface(Lambert.INSTANCE, radiance, sides, Rgb.BLACK, 0, ultraviolet, null, null, null);
    }

    /** A text that is equal for materials that look the same. Made on demand: few of thousands of lights need it. */
    public String look() {
        return text(glow, ultraviolet)
                + (described == null
                        ? " " + (sides == Material.EmissionPattern.Side.BOTH)
                        : ofSides(sides) + described.text(dispersion));
    }

    /**
     * The properties that surfaces of equal look have in common, emission aside.
     *
     * @param medium the text of the medium that is inside; null if there is none
     */
    record Look(Material material, String medium) {
        String text(double dispersion) {
            if (material instanceof Glass glass) {
                return " " + PhysicalSurface.text(glass.roughness()) + " " + PhysicalSurface.text(glass.absorption())
                        + " " + glass.multipleScattering()
                        + (glass.dispersion().isPresent() ? " " + dispersion : "")
                        + (glass.smoothRefraction() ? " refracting smoothly" : "");
            } else if (material instanceof Material.Scattering scattering) {
                return " " + scattering.roughness() + " " + medium;
            } else if (material instanceof Material.Matte matte) {
                return " " + matte.roughness();
            } else if (material instanceof Glossy glossy) {
                return " " + glossy.roughness() + " " + glossy.conductor() + " " + glossy.multipleScattering();
            } else if (material instanceof Coated coated) {
                return " " + coated.roughness() + " " + coated.indexOfRefraction() + " " + coated.nonlinear();
            } else if (material instanceof Principled p) {
                return " " + p.metallic() + " " + p.roughness() + " " + p.indexOfRefraction() + " " + p.specular()
                        + " " + p.clearcoat().share() + " "
                        + PhysicalSurface.text(p.clearcoat().roughness())
                        + (p.sheen().share() == 0
                                ? ""
                                : " sheen " + p.sheen().share() + " "
                                        + p.sheen().tint());
            } else if (material instanceof Material.Fluorescent dye) {
                return " " + dye.absorption() + " " + dye.emission() + " " + dye.yield();
            }
            return "";
        }
    }

    private static String ofSides(Material.EmissionPattern.Side sides) {
        return switch (sides) {
            case BOTH -> "";
            case FRONT -> " front";
            case BACK -> " back";
        };
    }

    /** Avoids a record's own text, whose first use takes as long as compiling a small scene. */
    private static String text(Rgb c) {
        return c.r() + "," + c.g() + "," + c.b();
    }

    private static String text(Texture.Amount amount) {
        return amount instanceof Texture.Amount.Constant constant
                ? Double.toString(constant.value())
                : amount.toString();
    }

    private static String text(Rgb c, double ultraviolet) {
        return ultraviolet == 0 ? text(c) : text(c) + "," + ultraviolet;
    }

    private static Rgb scaled(Rgb c, int exponent) {
        return new Rgb(scaled(c.r(), exponent), scaled(c.g(), exponent), scaled(c.b(), exponent));
    }

    /**
     * The coefficient in the frame; the largest double instead of infinity: nothing is darker than a medium that absorbs all light on the
     * shortest way.
     */
    private static double scaled(double absorption, int exponent) {
        return Math.min(Scale.scalb(absorption, exponent), Double.MAX_VALUE);
    }
}
