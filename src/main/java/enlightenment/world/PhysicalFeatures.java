package enlightenment.world;

import enlightenment.bsdf.Lambert;
import enlightenment.world.material.FaceMaterials;
import enlightenment.world.material.SurfaceMaterial;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.function.Predicate;

/** The features of physical shading that are modelled, and those that are not, because nothing in the scene requires them. */
final class PhysicalFeatures {
    final List<String> present = new ArrayList<>();
    final List<String> absent = new ArrayList<>();

    /**
     * Collects the features of a scene.
     *
     * @param materials of its objects and lights
     * @param mirrors spherical mirrors whose images of lights can be sampled, or null
     */
    PhysicalFeatures(PhysicalScene scene, FaceMaterials materials, MirrorBalls mirrors) {
        Collection<SurfaceMaterial> surfaces = materials.distinct();
        int lights = scene.lights.length;
        boolean hasBackground = scene.backgroundR > 0 || scene.backgroundG > 0 || scene.backgroundB > 0;
        add(lights > 0, "direct light of " + lights + (lights == 1 ? " light" : " lights"), "direct light");
        add(scene.maxBounces > 1, "indirect light", "indirect light");
        add(lights > 1, "choice of the light to sample", "choice of the light to sample");
        boolean isWeighted = any(surfaces, m -> !m.isBlack && !m.isDelta && m.bsdf != Lambert.INSTANCE)
                || java.util.Arrays.stream(scene.lights).anyMatch(l -> !l.isPoint && !l.isBall);
        add(
                lights > 0 && isWeighted || scene.surroundings != null,
                "multiple importance sampling of lights and directions",
                "multiple importance sampling (direct light has closed forms)");
        addCaustics(scene.hasCausticPass(), mirrors);
        boolean isPlain = scene.surroundings == null;
        String around = isPlain ? "constant surroundings" : "surroundings, sampled by what comes from each direction";
        add(hasBackground || !isPlain, around, "surroundings");
        add(!isPlain && !scene.surroundings.suns.isEmpty(), "disks of suns, sampled", "disks of suns");
        add(any(surfaces, m -> !m.isGlass && m.isDelta), "mirrors", "mirrors");
        add(any(surfaces, m -> m.isGlass), "refraction by Fresnel's equations, nested media", "refraction");
        add(any(surfaces, m -> !m.isDelta && !m.isBlack && m.bsdf != Lambert.INSTANCE), "rough lobes", "rough lobes");
        add(scene.hasUltraviolet, "ultraviolet light", "ultraviolet light");
        add(scene.hasAbsorption, "absorption in media", "absorption in media");
        add(materials.readImages(), "image textures", "image textures");
    }

    private void addCaustics(boolean hasPass, MirrorBalls mirrors) {
        String images = "sampling of the images of lights in mirror balls";
        add(hasPass, "caustics by light tracing", "caustics by light tracing");
        add(hasPass && mirrors != null, images + " (caustics seen in mirrors and through glass)", images);
    }

    private static boolean any(Collection<SurfaceMaterial> surfaces, Predicate<SurfaceMaterial> such) {
        return surfaces.stream().anyMatch(such);
    }

    private void add(boolean required, String there, String notThere) {
        if (required) {
            present.add(there);
        } else {
            absent.add(notThere);
        }
    }
}
