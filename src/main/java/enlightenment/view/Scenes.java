package enlightenment.view;

import enlightenment.camera.Camera;
import enlightenment.scene.Scene;

/** Variants of scenes. */
final class Scenes {
    private Scenes() {}

    /** A scene seen by another camera, as it stands. */
    static Scene seenBy(Scene s, Camera camera) {
        return new Scene(
                s.name(),
                s.width(),
                s.height(),
                camera,
                s.shading(),
                s.display(),
                s.textures(),
                s.materials(),
                s.lights(),
                s.objects(),
                s.render(),
                s.animation());
    }
}
