package enlightenment.world.light;

import enlightenment.bsdf.Reradiation;
import enlightenment.color.Rgb;
import enlightenment.world.material.FaceMaterials;
import enlightenment.world.material.SurfaceMaterial;
import java.util.List;

/** Roughly the amount of light by band in a scene with fluorescent surfaces. */
public final class LightBands {
    /** The solid angle of surroundings. */
    private static final double WHOLE_SPHERE = 4 * Math.PI;

    /** The least amount of each visible band, so that no path's throughput counts as 0 while it carries visible light. */
    private static final double LEAST = 1.0 / 16;

    private LightBands() {}

    /** Whether the scene has ultraviolet light, and a fluorescent surface that absorbs it. */
    public static boolean haveUltraviolet(FaceMaterials materials, List<PhysicalLight> points) {
        return materials.any(m -> m.reradiation != null && m.reradiation.gives(Reradiation.ULTRAVIOLET))
                && (materials.any(m -> m.glowUltraviolet > 0) || points.stream().anyMatch(p -> p.ultraviolet > 0));
    }

    /** The largest share of ultraviolet that a surface re-emits in a visible band. */
    public static double visibleOfUltraviolet(FaceMaterials materials) {
        double most = 0;
        for (SurfaceMaterial m : materials.distinct()) {
            for (int band = 0; m.reradiation != null && band < Reradiation.ULTRAVIOLET; band++) {
                most = Math.max(most, m.reradiation.share(band, Reradiation.ULTRAVIOLET));
            }
        }
        return most;
    }

    /**
     * By band, roughly the amount of light, relative, in a scene whose size is about 1.
     *
     * @param background radiance of the surroundings, by band
     */
    public static double[] typical(PhysicalLight[] lights, Rgb background) {
        double[] sum = new double[Reradiation.BANDS];
        add(sum, WHOLE_SPHERE, background.r(), background.g(), background.b(), 0);
        for (PhysicalLight light : lights) {
            double ofPoint = light.profile == null ? WHOLE_SPHERE : light.profile.solidAngle();
            double size = light.isPoint ? ofPoint : Math.PI * light.form.area();
            add(sum, size, light.meanR, light.meanG, light.meanB, light.meanUltraviolet);
        }
        double most = 0;
        for (double band : sum) {
            most = Math.max(most, band);
        }
        for (int band = 0; band < sum.length; band++) {
            sum[band] = most > 0 && most < Double.POSITIVE_INFINITY ? sum[band] / most : 0;
            sum[band] += band < Reradiation.ULTRAVIOLET ? LEAST : 0;
        }
        return sum;
    }

    private static void add(double[] sum, double factor, double r, double g, double b, double ultraviolet) {
        sum[0] = Math.fma(factor, r, sum[0]);
        sum[1] = Math.fma(factor, g, sum[1]);
        sum[2] = Math.fma(factor, b, sum[2]);
        sum[Reradiation.ULTRAVIOLET] = Math.fma(factor, ultraviolet, sum[Reradiation.ULTRAVIOLET]);
    }
}
