package enlightenment.world.light;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.camera.Camera;
import enlightenment.color.Rgb;
import enlightenment.emitter.SurfacePoint;
import enlightenment.geometry.Box;
import enlightenment.geometry.Cone;
import enlightenment.geometry.Cube;
import enlightenment.geometry.Cylinder;
import enlightenment.geometry.Disk;
import enlightenment.geometry.Mesh;
import enlightenment.geometry.Shape;
import enlightenment.geometry.Sphere;
import enlightenment.geometry.Torus;
import enlightenment.geometry.Transform;
import enlightenment.material.Material;
import enlightenment.material.Texture;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.mesh.MeshBuilder;
import enlightenment.primitive.Hit;
import enlightenment.primitive.Primitive;
import enlightenment.primitive.Ray;
import enlightenment.render.TestScenes;
import enlightenment.sampling.Hash;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.Shading;
import enlightenment.world.CompiledScene;
import enlightenment.world.SceneCompiler;
import enlightenment.world.surface.SurfaceInteraction;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** What textured lights emit at their points, and on the mean. */
class LightTextureTest {
    private static final int POINTS = 2_000;

    private static final Material CHECKERED = Material.Matte.of(Texture.of(Rgb.BLACK))
            .withRadiance(new Rgb(4, 3, 2))
            .withRadianceMap(new Texture.Checker(List.of(new Rgb(1, 0.5, 0.25), new Rgb(0.125, 1, 0)), 6));

    static List<Shape> shapes() {
        ExactPoint at = ExactPoint.of(1, 2, 3);
        return List.of(
                Sphere.of(at, 1.5),
                TestScenes.rectangle(0, 0, 0, 0, 2, 1, 3, 2, 1, 3, 0, 0),
                new Disk(at, new Vec3(1, 2, 3), 2),
                new Torus(at, new Vec3(0.5, 1, 0.25), 2, 0.5),
                new Cylinder(at, ExactPoint.of(2, 4, 4), 1, true),
                new Cone(at, ExactPoint.of(2, 4, 4), 1, 0.5, true),
                new Box(at, ExactPoint.of(2, 5, 4)),
                new Cube(at, 2, new Vec3(10, 20, 30)),
                mesh());
    }

    private static Mesh mesh() {
        MeshBuilder quad = new MeshBuilder();
        double[][] corners = {{0, 0, 0}, {2, 0, 1}, {2, 3, 0}, {0, 2, 0}};
        double[][] uv = {{-0.5, 0.25}, {1.25, 0}, {1, 1.5}, {0, 1}};
        for (int k = 0; k < corners.length; k++) {
            quad.vertex(corners[k][0], corners[k][1], corners[k][2]);
            quad.uv(uv[k][0], uv[k][1]);
        }
        quad.triangle(0, 1, 2);
        quad.triangle(0, 2, 3);
        return Mesh.of(quad.build(), Transform.IDENTITY);
    }

    private static CompiledScene compiled(Shape shape, Material material) {
        Scene scene = Scene.builder()
                .size(4, 4)
                .shading(Shading.Physical.DEFAULT)
                .camera(new Camera.Perspective(ExactPoint.of(0, 1, -9), ExactPoint.of(0, 1, 0), Vec3.Y, 40))
                .object(shape, material)
                .build();
        return SceneCompiler.compile(scene, RenderSettings.of(scene));
    }

    /** The two colours differ, and rounding decides between them at the edges of squares alone. */
    @ParameterizedTest
    @MethodSource("shapes")
    void aSampledPointEmitsWhatARayToItSees(Shape shape) {
        CompiledScene scene = compiled(shape, CHECKERED);
        assertTrue(scene.physical.lights.length > 0);
        for (PhysicalLight light : scene.physical.lights) {
            Primitive surface = light.surface;
            SurfacePoint p = new SurfacePoint();
            SurfaceInteraction seen = new SurfaceInteraction();
            double[] factor = new double[3];
            Hit scratch = new Hit();
            int others = 0;
            for (int k = 0; k < POINTS; k++) {
                light.form.samplePoint(Hash.unit(Hash.of(k, 1)), Hash.unit(Hash.of(k, 2)), p);
                light.texture.factor(p.x, p.y, p.z, scratch, factor);
                double off = 1.0 / 1024;
                Ray ray = Ray.of(
                        new Vec3(p.x + off * p.nx, p.y + off * p.ny, p.z + off * p.nz), new Vec3(-p.nx, -p.ny, -p.nz));
                assertTrue(surface.intersect(ray, seen.hit));
                seen.arrive(scene, light.id);
                seen.findEmission();
                boolean isSame = seen.emittedR == 4 * factor[0]
                        && seen.emittedG == 3 * factor[1]
                        && seen.emittedB == 2 * factor[2];
                others += isSame ? 0 : 1;
            }
            assertTrue(others <= POINTS / 100, others + " of " + shape);
        }
    }

    @Test
    void theMeanOfAWholeCheckerboardIsThatOfItsColours() {
        Shape square = TestScenes.rectangle(0, 0, 0, 0, 2, 0, 2, 2, 0, 2, 0, 0);
        PhysicalLight light = compiled(square, CHECKERED).physical.lights[0];
        assertEquals(4 * (1 + 0.125) / 2, light.meanR, 1e-12);
        assertEquals(3 * (0.5 + 1) / 2, light.meanG, 1e-12);
        assertEquals(2 * 0.25 / 2, light.meanB, 1e-12);
    }

    @Test
    void whatTheTextureLeavesBlackIsNoLight() {
        Texture black = new Texture.Checker(List.of(Rgb.BLACK, Rgb.BLACK), 2);
        Material dark =
                Material.Matte.of(Texture.of(Rgb.WHITE)).withRadiance(Rgb.WHITE).withRadianceMap(black);
        assertEquals(0, compiled(mesh(), dark).physical.lights.length);
    }

    @Test
    void aTextureOfOneColourIsPartOfTheRadiance() {
        Material tinted = Material.Matte.of(Texture.of(Rgb.WHITE))
                .withRadiance(new Rgb(4, 2, 8))
                .withRadianceMap(Texture.of(new Rgb(0.5, 0.25, 1)));
        PhysicalLight light = compiled(Sphere.of(ExactPoint.of(0, 0, 0), 1), tinted).physical.lights[0];
        assertEquals(null, light.texture);
        assertEquals(List.of(2.0, 0.5, 8.0), List.of(light.r, light.g, light.b));
    }
}
