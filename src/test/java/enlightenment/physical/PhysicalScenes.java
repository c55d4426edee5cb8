package enlightenment.physical;

import enlightenment.camera.Camera;
import enlightenment.color.Rgb;
import enlightenment.geometry.Shape;
import enlightenment.geometry.Sphere;
import enlightenment.light.Emission;
import enlightenment.light.Light;
import enlightenment.material.Material;
import enlightenment.material.Texture;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.render.TestScenes;
import enlightenment.scene.Scene;
import enlightenment.scene.Shading;
import java.util.OptionalInt;

/** What small scenes of physical light are made of. */
final class PhysicalScenes {
    static final Material WHITE = matte(0.75, 0.75, 0.75);
    static final Material RED = matte(0.6, 0.1, 0.05);
    static final Material GREEN = matte(0.1, 0.5, 0.15);

    private PhysicalScenes() {}

    static ExactPoint at(double x, double y, double z) {
        return ExactPoint.of(x, y, z);
    }

    static ExactPoint at(Vec3 v) {
        return at(v.x(), v.y(), v.z());
    }

    static Texture linear(double r, double g, double b) {
        return Texture.of(new Rgb(r, g, b));
    }

    static Material.Matte matte(double r, double g, double b) {
        return Material.Matte.of(linear(r, g, b));
    }

    static Shape ball(double x, double y, double z, double radius) {
        return Sphere.of(at(x, y, z), radius);
    }

    static Light sphereLight(double x, double y, double z, double radius, double radiance) {
        return new Light.Sphere(at(x, y, z), radius, Rgb.WHITE, Emission.radiance(Rgb.gray(radiance)));
    }

    /** Corners at (x, z) ± (half, half), at a height, with the front downwards. */
    static Light panel(double x, double y, double z, double half, Rgb radiance, boolean twoSided) {
        return new Light.Rectangle(
                at(x - half, y, z + half),
                at(x - half, y, z - half),
                at(x + half, y, z - half),
                at(x + half, y, z + half),
                Rgb.WHITE,
                twoSided,
                Emission.radiance(radiance));
    }

    static Shading.Physical shading(double background) {
        return new Shading.Physical(OptionalInt.empty(), Rgb.gray(background));
    }

    static Shading.Physical atMost(int bounces, double background) {
        return new Shading.Physical(OptionalInt.of(bounces), Rgb.gray(background));
    }

    /** A view along +z from (0, 1, −3.5) without anything to see. */
    static Scene.Builder view(int width, int height) {
        return Scene.builder()
                .size(width, height)
                .camera(new Camera.Perspective(at(0.02, 1.01, -3.5), at(0.01, 0.98, 0), Vec3.Y, 37))
                .shading(shading(0));
    }

    /** The walls of a room from −1 to 1, 2 high, open to the viewer; seen in 16 × 16 pixels. */
    static Scene.Builder room() {
        return room(WHITE, RED, GREEN);
    }

    /** That room with materials of floor, ceiling and back, of the left wall, and of the right one. */
    static Scene.Builder room(Material back, Material left, Material right) {
        return view(16, 16)
                .object(TestScenes.rectangle(-1, 0, -1, -1, 0, 1, 1, 0, 1, 1, 0, -1), back)
                .object(TestScenes.rectangle(-1, 2, -1, -1, 2, 1, 1, 2, 1, 1, 2, -1), back)
                .object(TestScenes.rectangle(-1, 0, 1, -1, 2, 1, 1, 2, 1, 1, 0, 1), back)
                .object(TestScenes.rectangle(-1, 0, -1, -1, 2, -1, -1, 2, 1, -1, 0, 1), left)
                .object(TestScenes.rectangle(1, 0, -1, 1, 2, -1, 1, 2, 1, 1, 0, 1), right);
    }
}
