package enlightenment.world;

import enlightenment.bsdf.SpecularReflection;
import enlightenment.camera.Camera;
import enlightenment.scene.Scene;
import enlightenment.scene.Shading;
import enlightenment.world.material.SurfaceMaterial;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;

/** The features that are modelled, and those that are not, because nothing in the scene requires them. */
final class SceneFeatures {
    private final List<String> present = new ArrayList<>();
    private final List<String> absent = new ArrayList<>();

    SceneFeatures(Scene scene, boolean withBvh, Iterable<SurfaceMaterial> surfaces) {
        if (scene.shading() instanceof Shading.Classic shading) {
            addClassic(scene, shading, surfaces);
        } else {
            addMatter(Shading.LightFeature.of(scene).keySet());
            if (hasLens(scene.camera())) {
                present.add("depth of field");
            }
        }
        add(
                withBvh,
                "bounding volume hierarchy over " + scene.objects().size() + " primitives",
                "bounding volume hierarchy (a loop over " + scene.objects().size() + " primitives is faster)");
    }

    private static boolean hasLens(Camera camera) {
        return camera instanceof Camera.Window w && w.pupilRadius() > 0
                || camera instanceof Camera.Perspective p
                        && p.lens().map(Camera.Lens::radius).orElse(0.0) > 0;
    }

    private void addMatter(Set<Shading.LightFeature> asked) {
        for (Shading.LightFeature feature : Shading.LightFeature.values()) {
            if (feature != Shading.LightFeature.CLASSIC_MOTION) {
                add(asked.contains(feature), feature.description(), feature.description());
            }
        }
    }

    private void addClassic(Scene scene, Shading.Classic shading, Iterable<SurfaceMaterial> surfaces) {
        boolean mirrors = false;
        boolean glass = false;
        boolean textures = false;
        for (SurfaceMaterial m : surfaces) {
            mirrors |= m.bsdf == SpecularReflection.INSTANCE;
            glass |= m.isGlass;
            textures |= m.hasImage();
        }
        int lights = scene.lights().size();
        add(lights > 0, "direct light of " + lights + (lights == 1 ? " light" : " lights"), "direct light");
        add(lights > 0 && shading.shadow() < 1, "shadows", "shadows");
        add(mirrors, "mirrors", "mirrors");
        add(glass, "refraction", "refraction");
        add(textures, "image textures", "image textures");
        if (scene.camera() instanceof Camera.Window w && w.pupilRadius() > 0) {
            absent.add("the pupil's radius (it is for rays from lights, which classic shading has none of)");
        }
    }

    private void add(boolean required, String there, String notThere) {
        if (required) {
            present.add(there);
        } else {
            absent.add(notThere);
        }
    }

    List<String> present() {
        return present;
    }

    List<String> absent() {
        return absent;
    }
}
