package enlightenment.render;

import enlightenment.camera.Camera;
import enlightenment.color.DisplayRgb;
import enlightenment.geometry.Rectangle;
import enlightenment.geometry.Sphere;
import enlightenment.light.Light;
import enlightenment.material.Material;
import enlightenment.material.Texture;
import enlightenment.math.ExactPoint;
import enlightenment.scene.Scene;

/** Scenes that several tests share. */
public final class TestScenes {
    private TestScenes() {}

    public static Material matte(double r, double g, double b) {
        return Material.Matte.of(Texture.of(new DisplayRgb(r, g, b)));
    }

    public static Material mirror(double reflectance) {
        return Material.Mirror.of(Texture.of(new DisplayRgb(reflectance, reflectance, reflectance)));
    }

    /** The paper's fire and ice in plain white, so that a pixel shows the coefficient of its shading. */
    public static Scene.Builder whiteFireAndIce() {
        Material white = matte(1, 1, 1);
        Material sky = new Material.Matte(Texture.of(DisplayRgb.WHITE), false);
        return Scene.builder()
                .size(800, 400)
                .camera(new Camera.Window(
                        ExactPoint.of(0, 1, -3),
                        ExactPoint.of(-3, 0, 0),
                        ExactPoint.of(-3, 3, 0),
                        ExactPoint.of(3, 3, 0),
                        ExactPoint.of(3, 0, 0),
                        0.5))
                .object(Sphere.of(ExactPoint.of(-2, 1, 4), 1.5), white)
                .object(Sphere.of(ExactPoint.of(2, 1, 4), 1.5), white)
                .object(Sphere.of(ExactPoint.of(0, 3, 4), 0.75), mirror(1))
                .object(rectangle(-6, -6, 8, -6, 6, 8, 6, 6, 8, 6, -6, 8), white)
                .object(rectangle(6, -6, -2, 6, 6, -2, 6, 6, 8, 6, -6, 8), white)
                .object(rectangle(-6, -6, -2, -6, -6, 8, 6, -6, 8, 6, -6, -2), white)
                .object(rectangle(-6, -6, -2, -6, 6, -2, -6, 6, 8, -6, -6, 8), white)
                .object(rectangle(-6, 6, -2, -6, 6, 8, 6, 6, 8, 6, 6, -2), sky)
                .light(new Light.Sphere(ExactPoint.of(0, 1, 1), 0.15, DisplayRgb.WHITE));
    }

    /** A rectangle by the coordinates of its corners. */
    public static Rectangle rectangle(double... c) {
        return new Rectangle(
                ExactPoint.of(c[0], c[1], c[2]),
                ExactPoint.of(c[3], c[4], c[5]),
                ExactPoint.of(c[6], c[7], c[8]),
                ExactPoint.of(c[9], c[10], c[11]));
    }
}
