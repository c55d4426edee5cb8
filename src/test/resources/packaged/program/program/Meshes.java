package program;

import enlightenment.camera.Camera;
import enlightenment.color.DisplayRgb;
import enlightenment.color.Rgb;
import enlightenment.geometry.Mesh;
import enlightenment.image.Image;
import enlightenment.image.ImageError;
import enlightenment.light.Emission;
import enlightenment.light.Light;
import enlightenment.material.Composite;
import enlightenment.material.Material;
import enlightenment.material.Texture;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.mesh.MeshBuilder;
import enlightenment.mesh.TriangleMesh;
import enlightenment.render.RenderRequest;
import enlightenment.render.RenderResult;
import enlightenment.render.Renderer;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.Shading;
import java.util.OptionalInt;

/** A mesh that a program builds, with what types nested in others are needed for: it is rendered, and its depth is where it stands. */
final class Meshes {
    private Meshes() {}

    /** The corner of a cube: half of its base's area times a third of its height. */
    private static TriangleMesh corner() {
        MeshBuilder builder = new MeshBuilder();
        builder.vertex(0, 0, 0);
        builder.vertex(1, 0, 0);
        builder.vertex(0, 1, 0);
        builder.vertex(0, 0, 1);
        builder.triangle(0, 2, 1);
        builder.triangle(0, 1, 3);
        builder.triangle(0, 3, 2);
        builder.triangle(1, 2, 3);
        return builder.build();
    }

    static void areRendered() {
        TriangleMesh mesh = corner();
        check(mesh.isClosed() && Math.abs(mesh.volume() - 1.0 / 6) < 1e-15, "the corner has the volume " + mesh.volume());
        Material grey = Material.Matte.of(new Texture.Solid(Rgb.gray(0.6)));
        Material red = Material.Matte.of(new Texture.Solid(new Rgb(0.6, 0.1, 0.1)));
        Scene scene = Scene.builder()
                .size(32, 32)
                .camera(new Camera.Perspective(ExactPoint.of(0.25, 0.25, -4), ExactPoint.of(0.25, 0.25, 0), Vec3.Y, 20))
                .shading(new Shading.Physical(OptionalInt.empty(), Rgb.gray(0.4)))
                .light(new Light.Sphere(ExactPoint.of(0, 0, -9), 1, DisplayRgb.WHITE, Emission.radiance(Rgb.gray(12))))
                .object(Mesh.of(mesh), new Composite.Mix(grey, red, Texture.Amount.of(0.5)))
                .build();
        RenderSettings settings = RenderSettings.of(scene).withSamples(4);
        RenderResult result = Renderer.render(
                RenderRequest.of(scene, settings).withAuxiliary(RenderResult.Auxiliary.DEPTH));
        Image depth = result.auxiliary().get(RenderResult.Auxiliary.DEPTH);
        float middle = depth.component(16, 16, 0);
        check(middle > 3.99 && middle < 4.05, "the mesh is " + middle + " away");
        Image again = Renderer.render(scene, settings.withThreads(1));
        check(ImageError.between(again, result.image()).rmse() == 0, "one thread makes another picture");
    }

    private static void check(boolean holds, String otherwise) {
        if (!holds) {
            throw new AssertionError(otherwise);
        }
    }
}
