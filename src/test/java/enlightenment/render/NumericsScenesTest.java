package enlightenment.render;

import static org.junit.jupiter.api.Assertions.assertEquals;

import enlightenment.camera.Camera;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.json.SceneReader;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The scenes whose pictures stand in docs/notes/numerics-pictures show what they claim. */
class NumericsScenesTest {
    private static Scene scene(String name) {
        return SceneReader.read(Path.of(System.getProperty("project.directory"), "scenes", "numerics", name));
    }

    private static RawPicture picture(Scene scene) {
        RenderSettings small =
                RenderSettings.of(scene).withSize(128, 72).withAntialias(2).with(new BuiltInMethod.RayTraceSettings(5));
        return RawPicture.of(scene, small.withThreads(1));
    }

    @ParameterizedTest
    @ValueSource(strings = {"nano.json", "giga.json"})
    void aBillionthAndABillionfoldLookLikeTheWhole(String name) {
        RawPicture unit = picture(scene("unit.json"));
        assertEquals(0, unit.pixelsBeyond(picture(scene(name)), 1e-9));
    }

    @Test
    void aBillionAwayTheBitsAreTheSame() {
        picture(scene("unit.json")).assertSameBits(picture(scene("offset.json")), "offset.json");
    }

    /** From a billion radii away the rays are parallel up to 3e-9: the picture is that of parallel rays. */
    @Test
    void aSphereABillionRadiiAwayLooksAsParallelRaysShowIt() {
        Scene far = scene("far-sphere.json");
        Scene parallel = new Scene(
                far.name(),
                far.width(),
                far.height(),
                new Camera.Orthographic(ExactPoint.of(0, 0, -10), ExactPoint.ORIGIN, Vec3.Y, 3),
                far.shading(),
                far.display(),
                far.textures(),
                far.materials(),
                far.lights(),
                far.objects(),
                far.render(),
                far.animation());
        RawPicture a = picture(far);
        RawPicture b = picture(parallel);
        // The coordinate towards the viewer is a double near 1e9: right to 1.2e-7 radii.
        assertEquals(0, a.pixelsBeyond(b, 1.2e-7));
    }
}
