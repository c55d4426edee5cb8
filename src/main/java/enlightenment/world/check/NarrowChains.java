package enlightenment.world.check;

import enlightenment.primitive.Primitive;
import enlightenment.world.CompiledScene;
import enlightenment.world.light.CausticPass;
import enlightenment.world.light.SpecularCasters;
import enlightenment.world.material.SurfaceMaterial;

/**
 * Finds chains of two narrow lobes, or of a narrow lobe and a mirror or smooth glass. Neither paths from the eye nor those from a small
 * light are likely to connect over one: a light sample at the first lobe seldom lies in the second one's highlight, and light paths that a
 * mirror sends to a narrow lobe are seldom reflected towards the eye.
 */
public final class NarrowChains {
    private NarrowChains() {}

    /**
     * Whether a scene of physical shading may have such a chain to a light that is {@linkplain CausticPass#takesNarrow() small} as seen
     * from there.
     */
    public static boolean leadToSmallLights(CompiledScene scene) {
        if (!scene.physical.hasCausticPass() || !scene.physical.caustics.takesNarrow()) {
            return false;
        }
        int narrow = 0;
        int sharp = 0;
        for (int id = 0; id < scene.primitives.length; id++) {
            boolean isNarrow = false;
            boolean isSharp = false;
            for (int face = 0; face < scene.primitives[id].faceCount(); face++) {
                SurfaceMaterial material = scene.material(id, face);
                isSharp |= material.any(SpecularCasters::isSharp);
                if (material.any(SpecularCasters::isNarrow)) {
                    isNarrow = true;
                    if (mayFollowItself(scene.primitives[id], material)) {
                        return true;
                    }
                }
            }
            narrow += isNarrow ? 1 : 0;
            sharp += isSharp && !isNarrow ? 1 : 0;
        }
        return narrow > 0 && narrow + sharp > 1;
    }

    /**
     * Whether two successive events may be on one surface: reflections in a concave one, or refractions at both ends of a segment through
     * glass.
     */
    private static boolean mayFollowItself(Primitive primitive, SurfaceMaterial material) {
        return material.isGlass || !primitive.isFlat() && !primitive.isConvex();
    }
}
