package enlightenment.emitter;

import enlightenment.camera.Camera;
import enlightenment.frame.BallCone;
import enlightenment.light.Light;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.world.SceneCompiler;
import enlightenment.world.light.ClassicLight;

/** Emitters as they are seen from a point. */
final class Views {
    private Views() {}

    /** The light as it is seen from the eye, which is the origin of the frame. */
    static ClassicLight compile(Light light) {
        Scene scene = Scene.builder()
                .camera(new Camera.Perspective(ExactPoint.ORIGIN, ExactPoint.of(0, 0, 1), Vec3.Y, 40))
                .light(light)
                .build();
        return SceneCompiler.compile(scene, RenderSettings.of(scene)).lights[0];
    }

    static EmitterView fromOrigin(Emitter emitter) {
        return from(Vec3.ZERO, emitter);
    }

    static EmitterView from(Vec3 viewer, Emitter emitter) {
        BallCone cone = new BallCone();
        Vec3 c = emitter.ballCenter();
        cone.set(c.x(), c.y(), c.z(), emitter.ballRadius(), viewer.x(), viewer.y(), viewer.z());
        EmitterView view = new EmitterView(cone);
        view.aim();
        return view;
    }
}
