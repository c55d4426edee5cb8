package enlightenment.view;

import enlightenment.camera.Camera;
import enlightenment.color.DisplayRgb;
import enlightenment.color.Rgb;
import enlightenment.geometry.Sphere;
import enlightenment.material.Material;
import enlightenment.material.Texture;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.render.Renderer;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.Shading;

/**
 * Renders a small picture that is not shown, to load the renderer's classes while the scene is read. Loading them takes
 * longer than the first coarse picture of most scenes.
 */
final class WarmUp implements Runnable {
    private static final int WIDTH = 24;
    private static final int HEIGHT = 16;
    private static final double FIELD_OF_VIEW = 40;
    private static final double DISTANCE = 5;
    private static final double LAMP_RADIUS = 0.5;

    WarmUp() {}

    @Override
    public void run() {
        Renderer.render(scene(), RenderSettings.of(scene()).withThreads(1));
    }

    /** A scene with two spheres, one of them emissive. */
    static Scene scene() {
        Texture white = Texture.of(DisplayRgb.WHITE);
        return Scene.builder()
                .size(WIDTH, HEIGHT)
                .camera(new Camera.Perspective(
                        ExactPoint.of(0, 0, -DISTANCE), ExactPoint.ORIGIN, Vec3.Y, FIELD_OF_VIEW))
                .shading(Shading.Physical.DEFAULT)
                .object(Sphere.of(ExactPoint.ORIGIN, 1), new Material.Matte(white, true, 0, Rgb.BLACK))
                .object(Sphere.of(ExactPoint.of(1, 1, -2), LAMP_RADIUS), new Material.Matte(white, true, 0, Rgb.WHITE))
                .build();
    }
}
