package enlightenment.world;

import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;

/** Lets tests of other packages say whether a scene gets a hierarchy. */
public final class HierarchyChoice {
    private HierarchyChoice() {}

    /** The scene, compiled with or without a hierarchy over its primitives. */
    public static CompiledScene compile(Scene scene, RenderSettings settings, boolean withBvh) {
        return SceneCompiler.compile(scene, settings, withBvh);
    }
}
