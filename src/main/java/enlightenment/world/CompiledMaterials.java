package enlightenment.world;

import enlightenment.frame.SceneFrame;
import enlightenment.material.Material;
import enlightenment.material.Texture;
import enlightenment.scene.Scene;
import enlightenment.scene.SceneObject;
import enlightenment.texture.ImageTexture;
import enlightenment.world.light.SceneImages;
import enlightenment.world.material.Dyes;
import enlightenment.world.material.PhysicalSurface;
import enlightenment.world.material.SurfaceMaterial;
import java.util.IdentityHashMap;
import java.util.Map;

/** The materials of a scene's objects as rendering reads them, with their images. */
final class CompiledMaterials {
    /** By identity: a material that is used many times is one object, and comparing records by value is slow to start. */
    final Map<Material, SurfaceMaterial> bySource = new IdentityHashMap<>();

    private final Scene scene;
    private final SceneFrame physical;
    private final SceneImages images;
    private final Runnable poll;
    private final Dyes dyes;

    /** @param physical the frame if the shading is physical, else null */
    CompiledMaterials(Scene scene, SceneFrame physical, SceneImages images, Runnable poll) {
        this.scene = scene;
        this.physical = physical;
        this.images = images;
        this.poll = poll;
        dyes = new Dyes(scene);
        for (SceneObject o : scene.objects()) {
            if (o.faces().isEmpty()) {
                add(o.material());
            }
            o.faces().forEach(this::add);
        }
    }

    private void add(Material m) {
        if (bySource.containsKey(m)) {
            return;
        }
        ImageTexture image = null;
        if (m.color() instanceof Texture.File file) {
            // What is prepared at once need not be asked for: a single image is such.
            if (images.haveBeenRead()) {
                poll.run();
            }
            image = images.of(file, physical != null, scene);
        }
        PhysicalSurface surface = physical == null ? null : PhysicalSurface.of(m, physical, dyes);
        bySource.put(m, new SurfaceMaterial(m, image, surface));
    }
}
