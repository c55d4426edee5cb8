package enlightenment.transport.path;

import enlightenment.bsdf.GlossyReflection;
import enlightenment.bsdf.Scattering;
import enlightenment.primitive.Ray;
import enlightenment.transport.ray.PathFollower;
import enlightenment.world.material.SurfaceMaterial;

/** What share of light a surface reflects: for pictures of that alone. */
final class Albedo {
    private Albedo() {}

    /**
     * Turns the colour of the surface that a path is at into its reflectance.
     *
     * @param hasUltraviolet whether there is light beyond violet, which fluorescent surfaces show
     * @param rgb the colour; receives what share of light that comes along the normal is reflected, by band; of a fluorescent surface, how
     *     much leaves of light that has the same in all bands that there are
     */
    static void find(PathFollower path, Ray ray, SurfaceMaterial material, boolean hasUltraviolet, double[] rgb) {
        if (material.reradiation != null) {
            double[] light = {1, 1, 1, hasUltraviolet ? 1 : 0};
            material.reradiation.scatter(rgb, light);
            System.arraycopy(light, 0, rgb, 0, rgb.length);
        }
        if (material.bsdf instanceof GlossyReflection metal) {
            Scattering s = path.arrive(ray, rgb);
            metal.reflectAtNormal(s);
            rgb[0] = s.valueR;
            rgb[1] = s.valueG;
            rgb[2] = s.valueB;
        }
    }
}
