package enlightenment.transport.path;

import enlightenment.bsdf.GlossyReflection;
import enlightenment.bsdf.Scattering;
import enlightenment.primitive.Ray;
import enlightenment.transport.ray.PathFollower;
import enlightenment.world.material.SurfaceMaterial;

/** Reflectance of surfaces, for pictures of it. */
final class Albedo {
    private Albedo() {}

    /**
     * Converts the colour of the current surface to its reflectance.
     *
     * @param hasUltraviolet whether the scene has ultraviolet, which fluorescent surfaces show
     * @param rgb the colour; receives the reflectance at normal incidence, 0..1 by band; of a fluorescent surface the reflected and
     *     re-emitted light per incident light that is equal in all bands
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
