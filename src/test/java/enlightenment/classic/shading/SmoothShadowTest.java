package enlightenment.classic.shading;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.camera.Camera;
import enlightenment.color.DisplayRgb;
import enlightenment.geometry.Mesh;
import enlightenment.geometry.Sphere;
import enlightenment.light.Light;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.mesh.TriangleMesh;
import enlightenment.primitive.Ray;
import enlightenment.render.TestScenes;
import enlightenment.sampling.SobolSampler;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.Shading;
import enlightenment.world.CompiledScene;
import enlightenment.world.SceneCompiler;
import enlightenment.world.parts.RayCounters;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Shadow rays of a smooth mesh start where the smooth surface would be, and what is in the way of these counts. */
class SmoothShadowTest {
    private static final double AMBIENT = 0.25;

    /** An octahedron around the origin that is shaded as a ball. */
    private static TriangleMesh octahedron() {
        float[] corners = {1, 0, 0, 0, 1, 0, 0, 0, 1, -1, 0, 0, 0, -1, 0, 0, 0, -1};
        int[] faces = {0, 1, 2, 1, 3, 2, 3, 4, 2, 4, 0, 2, 1, 0, 5, 3, 1, 5, 4, 3, 5, 0, 4, 5};
        return TriangleMesh.of(corners, faces).smooth();
    }

    private static double colorOfFace(Scene scene, boolean withBvh) {
        RenderSettings settings = RenderSettings.of(scene);
        CompiledScene compiled = SceneCompiler.compile(scene, settings, withBvh);
        ClassicShader shader = ClassicShader.ofColors(compiled, 4, new RayCounters(compiled.kindNames.size()));
        shader.beginTile(0, 0, 1, 1);
        SobolSampler sampler = new SobolSampler();
        sampler.pixel(0, 0, 0);
        Ray ray = new Ray();
        compiled.camera.ray(0.5, 0.5, sampler, ray);
        double[] rgb = new double[3];
        shader.shade(ray, sampler, rgb);
        return rgb[0];
    }

    /**
     * The camera looks at the middle m of a face, (1, 1, 1)/3 with the normal n = (1, 1, 1)/√3. The planes across the normals of the corners
     * are above m by 1 − 1/3 each: the smooth surface is 2/3 away along the mean of these normals, at m + 2/3 m. A light is far along +x;
     * a small ball stands on the way from there to it, 2/9 above the way from m.
     */
    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void whatStandsBeforeTheSmoothSurfaceThrowsAShadow(boolean withBvh) {
        Scene.Builder scene = Scene.builder()
                .size(1, 1)
                .camera(new Camera.Perspective(
                        ExactPoint.of(4 + 1 / 3.0, 4 + 1 / 3.0, 4 + 1 / 3.0), ExactPoint.of(0, 0, 0), Vec3.Y, 1))
                .shading(new Shading.Classic(AMBIENT, 0, DisplayRgb.BLACK, 5))
                .light(new Light.Point(ExactPoint.of(100, 5 / 9.0, 5 / 9.0), DisplayRgb.WHITE))
                .object(Mesh.of(octahedron()), TestScenes.matte(1, 1, 1));
        double lit = colorOfFace(scene.build(), withBvh);
        assertTrue(lit > AMBIENT + 0.3, "the face is turned to the light: " + lit);
        scene.object(Sphere.of(ExactPoint.of(2, 5 / 9.0, 5 / 9.0), 0.05), TestScenes.matte(1, 1, 1));
        assertEquals(AMBIENT, colorOfFace(scene.build(), withBvh), 1e-12);
    }
}
