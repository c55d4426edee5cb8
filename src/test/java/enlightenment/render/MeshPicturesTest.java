package enlightenment.render;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.camera.Camera;
import enlightenment.color.DisplayRgb;
import enlightenment.color.Rgb;
import enlightenment.geometry.Mesh;
import enlightenment.geometry.Shape;
import enlightenment.geometry.Sphere;
import enlightenment.geometry.Transform;
import enlightenment.geometry.Transform.Rotate;
import enlightenment.geometry.Transform.Scale;
import enlightenment.geometry.Transform.Translate;
import enlightenment.light.Emission;
import enlightenment.light.Light;
import enlightenment.material.Glass;
import enlightenment.material.Material;
import enlightenment.material.Texture;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.mesh.TestMeshes;
import enlightenment.mesh.TriangleMesh;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.SceneObject;
import enlightenment.scene.Shading;
import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.OptionalInt;
import java.util.Random;
import java.util.function.UnaryOperator;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Pictures of meshes do not depend on how these are placed, and go to those of what the meshes stand for. */
class MeshPicturesTest {
    private static final Material MATTE = Material.Matte.of(Texture.of(new Rgb(0.7, 0.4, 0.2)));
    private static final Material MIRROR = Material.Mirror.of(Texture.of(new Rgb(0.9, 0.9, 0.8)));
    private static final Material GLASS = Glass.of(Texture.of(new Rgb(0.9, 1, 0.95)), 1.5);

    /** All coordinates are multiples of 2^-12: transforms by powers of two and right angles are exact for floats. */
    private static final TriangleMesh BALL = smooth(rounded(TestMeshes.icosphere(1)));

    private static final TriangleMesh CUBE =
            TestMeshes.moved(TestMeshes.cube(), false, v -> v.minus(new Vec3(0.5, 0.5, 0.5)));
    private static final TriangleMesh GEM = rounded(TestMeshes.icosphere(0));

    private static TriangleMesh rounded(TriangleMesh mesh) {
        return TestMeshes.moved(mesh, false, v -> new Vec3(rounded(v.x()), rounded(v.y()), rounded(v.z())));
    }

    private static double rounded(double v) {
        return Math.rint(v * 0x1p12) * 0x1p-12;
    }

    /** With a normal at each vertex that points away from the origin. */
    private static TriangleMesh smooth(TriangleMesh mesh) {
        float[] normals = new float[3 * mesh.vertices()];
        for (int i = 0; i < normals.length; i++) {
            normals[i] = (float) mesh.coordinate(i / 3, i % 3);
        }
        return mesh.withNormals(normals);
    }

    private static Scene.Builder view() {
        return Scene.builder()
                .size(48, 24)
                .camera(new Camera.Perspective(ExactPoint.of(0.1, 1.3, -5), ExactPoint.of(0, 0.7, 0), Vec3.Y, 30))
                .shading(new Shading.Physical(OptionalInt.empty(), new Rgb(0.3, 0.4, 0.5)))
                .object(
                        TestScenes.rectangle(-4, -0.5, -4, -4, -0.5, 4, 4, -0.5, 4, 4, -0.5, -4),
                        Material.Matte.of(Texture.of(Rgb.gray(0.5))))
                .light(new Light.Sphere(ExactPoint.of(-2, 3, -2), 0.3, Rgb.WHITE, Emission.radiance(Rgb.gray(30))));
    }

    private static Scene scene(UnaryOperator<Shape> shape) {
        return view().object(shape.apply(Mesh.of(BALL, moved(-1.5, 0.75))), MATTE)
                .object(shape.apply(Mesh.of(CUBE, moved(0.125, 0.5))), MIRROR)
                .object(shape.apply(Mesh.of(GEM, moved(1.75, 0.625))), GLASS)
                .build();
    }

    private static Transform moved(double x, double y) {
        return Transform.of(new Translate(ExactPoint.of(x, y, 0.25)));
    }

    private static RenderSettings settings(Scene scene) {
        return RenderSettings.of(scene).withAntialias(2).withThreads(1).withMethod(BuiltInMethod.RAYTRACE);
    }

    private static float[] picture(Scene scene) {
        return Renderer.render(scene, settings(scene)).toArray();
    }

    /** A shape as it stands after a change of its mesh and one of its place that undo each other. */
    private static UnaryOperator<Shape> baked(Transform transform, boolean mirrors, UnaryOperator<Vec3> inverse) {
        return shape -> {
            Mesh mesh = (Mesh) shape;
            TriangleMesh there = TestMeshes.moved(mesh.triangles(), mirrors, inverse);
            return Mesh.of(withNormalsOf(mesh.triangles(), there, transform), transform.then(mesh.transform()));
        };
    }

    /** With the normals that a transform, as it does with normals, takes to those of another mesh: Mᵀ·n. */
    private static TriangleMesh withNormalsOf(TriangleMesh mesh, TriangleMesh there, Transform transform) {
        if (!mesh.hasNormals()) {
            return there;
        }
        float[] normals = new float[3 * mesh.vertices()];
        for (int i = 0; i < normals.length; i++) {
            Vec3 n = mesh.normal(i / 3);
            double sum = 0;
            for (int row = 0; row < 3; row++) {
                sum += transform.row(row).component(i % 3) * n.component(row);
            }
            normals[i] = (float) sum;
        }
        return there.withNormals(normals);
    }

    /** Instances are followed in coordinates of their own, which round otherwise: pixels are the same but for a few roundings. */
    @Test
    void aTransformIsWhatItDoesToVertices() {
        float[] expected = picture(scene(s -> s));
        List<String> wrong = new ArrayList<>();
        compare(expected, "scale", baked(Transform.of(new Scale(new Vec3(4, 4, 4))), false, v -> v.times(0.25)), wrong);
        compare(
                expected,
                "stretch",
                baked(
                        Transform.of(new Scale(new Vec3(2, 0.5, 4))),
                        false,
                        v -> new Vec3(v.x() / 2, v.y() * 2, v.z() / 4)),
                wrong);
        compare(
                expected,
                "turn",
                baked(Transform.of(new Rotate(new Vec3(0, 0, 90))), false, v -> new Vec3(v.y(), -v.x(), v.z())),
                wrong);
        compare(
                expected,
                "mirror",
                baked(Transform.of(new Scale(new Vec3(-1, 1, 1))), true, v -> new Vec3(-v.x(), v.y(), v.z())),
                wrong);
        Vec3 by = new Vec3(0.5, -0.25, 2);
        compare(
                expected,
                "move",
                baked(Transform.of(new Translate(ExactPoint.of(by.x(), by.y(), by.z()))), false, v -> v.minus(by)),
                wrong);
        assertEquals(List.of(), wrong);
    }

    private static void compare(float[] expected, String what, UnaryOperator<Shape> shape, List<String> wrong) {
        float[] other = picture(scene(shape));
        int beyond = 0;
        for (int i = 0; i < expected.length; i++) {
            beyond += Math.abs(expected[i] - other[i]) <= 1e-6 * expected[i] ? 0 : 1;
        }
        if (beyond > 0) {
            wrong.add(what + ": " + beyond + " of " + expected.length);
        }
    }

    @Test
    void instancesOfOneMeshAreAsMeshesOfTheirOwn() {
        float[] shared = picture(twice(BALL, BALL));
        assertArrayEquals(shared, picture(twice(BALL, smooth(rounded(TestMeshes.icosphere(1))))), "two meshes");
        Scene scene = twice(BALL, BALL);
        List<SceneObject> objects = new ArrayList<>(scene.objects());
        Collections.shuffle(objects, new Random(1));
        assertArrayEquals(shared, picture(ImageInvarianceTest.withObjects(scene, objects)), "another order");
    }

    private static Scene twice(TriangleMesh one, TriangleMesh other) {
        Transform turned = Transform.of(new Rotate(new Vec3(10, 20, 30)), new Translate(ExactPoint.of(0.9, 0.7, 0)));
        return view().object(Mesh.of(one, moved(-1, 0.5)), MATTE)
                .object(Mesh.of(other, turned), GLASS)
                .build();
    }

    @Test
    void aSceneOfMeshesTimesAPowerOfTwoOrElsewhereGivesTheSameBits() {
        Scene scene = scene(s -> s);
        float[] expected = picture(scene);
        for (int k : new int[] {1, -300, 899}) {
            assertArrayEquals(expected, picture(MovedScene.scaledByPowerOfTwo(scene, k)), "2^" + k);
        }
        for (String t : List.of("1e3", "-1234567.000000000000000000000000000000891")) {
            assertArrayEquals(expected, picture(MovedScene.translated(scene, new BigDecimal(t))), t);
        }
    }

    @ParameterizedTest
    @EnumSource(BuiltInMethod.class)
    void threadsAndTilesChangeNoBitOfMeshes(BuiltInMethod method) {
        Scene scene = scene(s -> s);
        RenderSettings settings = settings(scene).withSize(16, 8).withMethod(method);
        float[] expected = Renderer.render(scene, settings).toArray();
        float[] other =
                Renderer.render(scene, settings.withThreads(3).withTileSize(5)).toArray();
        assertArrayEquals(expected, other);
    }

    private static Scene classic(Shape shape) {
        return Scene.builder()
                .size(24, 24)
                .camera(new Camera.Orthographic(ExactPoint.of(0, 0, -5), ExactPoint.of(0, 0, 0), Vec3.Y, 2.4))
                .shading(new Shading.Classic(0.3, 0.5, DisplayRgb.BLACK, 5))
                .object(shape, TestScenes.matte(1, 0.8, 0.6))
                .light(new Light.Point(ExactPoint.of(0.5, 1, -6), DisplayRgb.WHITE))
                .build();
    }

    private static double[] classicErrors(boolean isSmooth) {
        Scene ball = classic(Sphere.of(ExactPoint.of(0, 0, 0), 1));
        RenderSettings settings =
                RenderSettings.of(ball).withAntialias(1).withThreads(1).with(new BuiltInMethod.RayTraceSettings(1));
        RawPicture expected = RawPicture.of(ball, settings);
        double[] errors = new double[4];
        for (int cuts = 1; cuts <= 4; cuts++) {
            Mesh mesh = Mesh.of(isSmooth ? TestMeshes.ball(cuts) : TestMeshes.icosphere(cuts));
            RawPicture other = RawPicture.of(classic(mesh), settings);
            double sum = 0;
            int n = 0;
            for (int pixel = 0; pixel < expected.pixels(); pixel++) {
                double x = (pixel % 24 + 0.5) / 10 - 1.2;
                double y = (pixel / 24 + 0.5) / 10 - 1.2;
                // The middle of the ball, where no corner of a level is a silhouette and light comes to all that is
                // seen.
                if (x * x + y * y < 0.5) {
                    sum += Math.abs(expected.rgb()[3 * pixel] - other.rgb()[3 * pixel]);
                    n++;
                }
            }
            errors[cuts - 1] = sum / n;
        }
        return errors;
    }

    /** Normals of vertices are exact; between them both they and places are off by the square of a triangle's size. */
    @Test
    void aSmoothBallOfTrianglesGoesToTheBallAsTrianglesAreMore() {
        double[] errors = classicErrors(true);
        for (int k = 1; k < errors.length; k++) {
            double ratio = errors[k - 1] / errors[k];
            assertTrue(ratio > 2.8 && ratio < 5.2, Arrays.toString(errors));
        }
        assertTrue(errors[3] < 2e-3, Arrays.toString(errors));
    }

    /** Flat triangles have normals that are off by their size. */
    @Test
    void aFlatBallOfTrianglesGoesToTheBallMoreSlowly() {
        double[] errors = classicErrors(false);
        for (int k = 1; k < errors.length; k++) {
            double ratio = errors[k - 1] / errors[k];
            assertTrue(ratio > 1.5 && ratio < 2.7, Arrays.toString(errors));
        }
    }
}
