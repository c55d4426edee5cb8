package enlightenment.view;

import enlightenment.camera.Camera;
import enlightenment.scene.Scene;
import java.util.List;

/** Copies of scenes with another camera or display. */
final class Scenes {
    private Scenes() {}

    /**
     * A copy of a scene with another camera and display, which also hold at all shutter instants. The scene's own camera stays as it is, and may
     * move while the shutter is open.
     */
    static Scene seenAs(Scene s, Camera camera, Scene.Display display) {
        if (camera.equals(s.camera())) {
            return with(s, camera, display).withInstants(s.instants());
        }
        List<Scene> instants = s.instants().stream()
                .map(moment -> with(moment, camera, moment.display()))
                .toList();
        return with(s, camera, display).withInstants(instants);
    }

    /** A copy of a scene with another camera and without shutter instants. */
    static Scene seenBy(Scene s, Camera camera) {
        return with(s, camera, s.display());
    }

    private static Scene with(Scene s, Camera camera, Scene.Display display) {
        return new Scene(
                s.name(),
                s.width(),
                s.height(),
                camera,
                s.shading(),
                display,
                s.textures(),
                s.materials(),
                s.lights(),
                s.objects(),
                s.render(),
                s.animation());
    }
}
