package enlightenment.physical;

import static enlightenment.physical.PhysicalScenes.at;
import static enlightenment.physical.PhysicalScenes.ball;
import static enlightenment.physical.PhysicalScenes.matte;
import static enlightenment.physical.PhysicalScenes.shading;

import enlightenment.camera.Camera;
import enlightenment.color.Rgb;
import enlightenment.geometry.Mesh;
import enlightenment.geometry.Torus;
import enlightenment.geometry.Transform;
import enlightenment.image.Image;
import enlightenment.material.Material;
import enlightenment.material.Texture;
import enlightenment.math.Vec3;
import enlightenment.mesh.MeshBuilder;
import enlightenment.render.TestScenes;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.MethodSource;

/** Surfaces that glow by a texture: closed forms, and the same picture by every method. */
class RadianceMapTest {
    private static final double REFLECTANCE = 0.6;

    private static final Texture CHECKER = new Texture.Checker(List.of(new Rgb(1, 0.25, 0), new Rgb(0, 0.75, 0.5)), 3);

    private static Material lamp(Rgb radiance, Texture map) {
        return Material.Matte.of(Texture.of(Rgb.BLACK)).withRadiance(radiance).withRadianceMap(map);
    }

    private static RenderSettings settings(Scene scene, BuiltInMethod method, int antialias) {
        return RenderSettings.of(scene).withMethod(method).withThreads(1).withAntialias(antialias);
    }

    /** Lambert's sum: irradiance at the origin, with the normal +y, of a polygon of radiance 1 above the horizon. */
    private static double irradiance(Vec3... corners) {
        double sum = 0;
        for (int k = 0; k < corners.length; k++) {
            Vec3 a = corners[k].normalized();
            Vec3 b = corners[(k + 1) % corners.length].normalized();
            sum += Math.acos(a.dot(b)) * a.cross(b).normalized().y() / 2;
        }
        return Math.abs(sum);
    }

    /** The squares of a panel from (−1, 1, −1) to (2, 1, 2), with u along x and v along z, above the origin. */
    private static double[] expected(double x0, double size, double y) {
        double[][] colors = {{1, 0.25, 0}, {0, 0.75, 0.5}};
        double[] sum = new double[3];
        for (int i = 0; i < 3; i++) {
            for (int k = 0; k < 3; k++) {
                double x = x0 + i * size;
                double z = x0 + k * size;
                double e = irradiance(
                        new Vec3(x, y, z),
                        new Vec3(x + size, y, z),
                        new Vec3(x + size, y, z + size),
                        new Vec3(x, y, z + size));
                for (int band = 0; band < 3; band++) {
                    sum[band] += REFLECTANCE / Math.PI * e * 2 * colors[(i + k) % 2][band];
                }
            }
        }
        return sum;
    }

    static List<BuiltInMethod> pointMethods() {
        return List.of(BuiltInMethod.RAYTRACE, BuiltInMethod.CLUSTER, BuiltInMethod.BIDIRECTIONAL);
    }

    @ParameterizedTest
    @MethodSource("pointMethods")
    void theIrradianceOfACheckeredPanelIsTheSumOfItsSquares(BuiltInMethod method) {
        // Texture coordinates begin at the panel's upper left corner.
        Scene scene = Scene.builder()
                .size(4, 4)
                .shading(shading(0))
                .camera(new Camera.Perspective(at(0, 0.5, 0), at(0, 0, 0), Vec3.Z, 0.01))
                .object(
                        TestScenes.rectangle(-9, 0, -9, -9, 0, 9, 9, 0, 9, 9, 0, -9),
                        matte(REFLECTANCE, REFLECTANCE, REFLECTANCE))
                .object(TestScenes.rectangle(-1, 1, 2, -1, 1, -1, 2, 1, -1, 2, 1, 2), lamp(Rgb.gray(2), CHECKER))
                .build();
        new ClosedForms.Known(method.word(), scene, expected(-1, 1, 1)).assertShown(settings(scene, method, 8));
    }

    private static Mesh screen() {
        MeshBuilder quad = new MeshBuilder();
        double[][] corners = {{-1.5, 0.5, 1.9}, {0.5, 0.5, 1.9}, {0.5, 1.5, 1.7}, {-1.5, 1.5, 1.7}};
        double[][] uv = {{0, 0}, {2, 0}, {2, 1}, {0, 1}};
        for (int k = 0; k < corners.length; k++) {
            quad.vertex(corners[k][0], corners[k][1], corners[k][2]);
            quad.uv(uv[k][0], uv[k][1]);
        }
        quad.triangle(0, 2, 1);
        quad.triangle(0, 3, 2);
        return Mesh.of(quad.build(), Transform.IDENTITY);
    }

    /** A ball, a ring and a mesh that glow in a room, with or without a mirror that throws caustics. */
    private static Scene room(boolean hasMirror) {
        Scene.Builder room = Scene.builder()
                .size(16, 16)
                .shading(shading(0.05))
                .camera(new Camera.Perspective(at(0, 1.2, -3), at(0, 0.6, 0), Vec3.Y, 50))
                .object(TestScenes.rectangle(-4, 0, -4, -4, 0, 4, 4, 0, 4, 4, 0, -4), matte(0.7, 0.6, 0.5))
                .object(TestScenes.rectangle(-4, 0, 2, -4, 4, 2, 4, 4, 2, 4, 0, 2), matte(0.5, 0.6, 0.7))
                .object(ball(-0.9, 0.5, 0, 0.4), lamp(new Rgb(3, 2, 1), CHECKER))
                .object(new Torus(at(0.9, 0.3, 0.4), new Vec3(0, 1, 0.5), 0.5, 0.2), lamp(new Rgb(1, 2, 3), CHECKER))
                .object(screen(), lamp(Rgb.gray(4), CHECKER));
        if (hasMirror) {
            room.object(ball(0.3, 0.35, -0.7, 0.35), Material.Mirror.of(Texture.of(new Rgb(0.9, 0.9, 0.9))));
        }
        return room.build();
    }

    @ParameterizedTest
    @EnumSource(
            value = BuiltInMethod.class,
            names = {"CLUSTER", "LIGHT", "BIDIRECTIONAL", "METROPOLIS"})
    void allMethodsMakeThePictureOfSinglePaths(BuiltInMethod method) {
        // Light paths do not find what mirrors show.
        Scene scene = room(method != BuiltInMethod.LIGHT);
        List<Image> traced = Rendered.seeds(scene, settings(scene, BuiltInMethod.RAYTRACE, 4), 100, 12);
        List<Image> others = Rendered.seeds(scene, settings(scene, method, 4), 1, 12);
        Rendered.assertPartsAgree(traced, others, 48);
    }
}
