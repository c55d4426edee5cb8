package enlightenment.world.material;

import enlightenment.bsdf.Reradiation;
import enlightenment.light.Light;
import enlightenment.material.Material;
import enlightenment.scene.Scene;
import enlightenment.scene.SceneObject;

/** Compiles the dyes of fluorescent materials, without what the light of the scene does not require. */
public final class Dyes {
    private final Scene scene;

    /** Whether the scene has ultraviolet light; null until it is needed. */
    private Boolean hasUltraviolet;

    public Dyes(Scene scene) {
        this.scene = scene;
    }

    /** The reradiation of a dye; null if it re-emits nothing: then the surface is a matte one. */
    Reradiation of(Material.Fluorescent dye) {
        Reradiation r = new Reradiation(
                dye.absorption().low(),
                dye.absorption().high(),
                dye.emission().low(),
                dye.emission().high(),
                dye.yield());
        if (hasUltraviolet == null) {
            hasUltraviolet = hasUltraviolet();
        }
        return r.isIdle(hasUltraviolet) ? null : r;
    }

    private boolean hasUltraviolet() {
        for (Light light : scene.lights()) {
            if (light.ultraviolet() > 0) {
                return true;
            }
        }
        for (SceneObject object : scene.objects()) {
            if (object.material().ultraviolet() > 0 || object.faces().stream().anyMatch(m -> m.ultraviolet() > 0)) {
                return true;
            }
        }
        return false;
    }
}
