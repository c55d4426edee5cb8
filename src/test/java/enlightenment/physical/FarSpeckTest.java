package enlightenment.physical;

import static enlightenment.physical.PhysicalScenes.at;
import static enlightenment.physical.PhysicalScenes.ball;
import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.color.Rgb;
import enlightenment.geometry.Box;
import enlightenment.light.Emission;
import enlightenment.light.Light;
import enlightenment.material.Glass;
import enlightenment.render.Renderer;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.SceneException;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/**
 * A speck far behind the viewer makes the scene's frame larger, so that all that is seen becomes small in it: no bit changes, up to the
 * extents that docs/notes/numerics.md promises. As {@code ImageInvarianceTest} has it, with densities per area and their squares.
 */
class FarSpeckTest {
    private static final int[] EXPONENTS = {30, 200, 260, 360, 395};

    private static Scene.Builder room(Light light) {
        return PhysicalScenes.view(8, 8)
                .shading(PhysicalScenes.atMost(6, 0))
                .object(new Box(at(-1.5, -0.5, -4), at(1.5, 2.5, 1.7)), PhysicalScenes.WHITE)
                .object(ball(-0.5, 0.4, 0.6, 0.45), PhysicalScenes.RED)
                .object(ball(0.6, 0.5, 0.1, 0.5), Glass.of(PhysicalScenes.linear(1, 0.9, 0.95), 1.5))
                .light(light);
    }

    private static float[] picture(Scene.Builder room, BuiltInMethod method) {
        Scene scene = room.build();
        return Renderer.render(
                        scene,
                        RenderSettings.of(scene)
                                .withMethod(method)
                                .withAntialias(4)
                                .withThreads(1))
                .toArray();
    }

    private static void assertSame(Light light, BuiltInMethod method) {
        float[] expected = picture(room(light), method);
        double sum = 0;
        for (float v : expected) {
            sum += v;
        }
        assertTrue(sum / expected.length > 0.01, "it is dark");
        for (int exponent : EXPONENTS) {
            Scene.Builder larger =
                    room(light).object(ball(0, 1, Math.scalb(-1.0, exponent), 0.01), PhysicalScenes.GREEN);
            assertArrayEquals(expected, picture(larger, method), "speck at 2^" + exponent);
        }
    }

    @ParameterizedTest
    @EnumSource(BuiltInMethod.class)
    void aSpeckFarAwayChangesNoBitUnderABallOfLight(BuiltInMethod method) {
        assertSame(PhysicalScenes.sphereLight(0.2, 1.9, -0.3, 0.3, 5), method);
    }

    /** There, what is squared and cubed is 0 or infinite. */
    @ParameterizedTest
    @EnumSource(BuiltInMethod.class)
    void whatIsBeyondThePromiseIsRefusedByTheNameOfTheFarthest(BuiltInMethod method) {
        for (int exponent : new int[] {480, 520, 700, 1000}) {
            Scene.Builder larger = room(PhysicalScenes.sphereLight(0.2, 1.9, -0.3, 0.3, 5))
                    .object(ball(0, 1, Math.scalb(-1.0, exponent), 0.01), PhysicalScenes.GREEN);
            SceneException e = assertThrows(SceneException.class, () -> picture(larger, method));
            assertEquals("/objects/3", e.problems().get(0).pointer());
            long digits = Math.round(exponent * StrictMath.log10(2));
            String message = e.problems().get(0).message();
            // The smallest is 0.6 wide; what is too small for a radius in doubles has none, and then it is the room,
            // 5.7 wide.
            assertTrue(
                    message.contains("1e" + digits + " ")
                            || message.contains("1e" + (digits + 1) + " ")
                            || exponent == 1000 && message.contains("1e" + (digits - 1) + " "),
                    digits + ": " + message);
        }
    }

    @ParameterizedTest
    @EnumSource(BuiltInMethod.class)
    void aSpeckFarAwayChangesNoBitUnderAPointLight(BuiltInMethod method) {
        assertSame(new Light.Point(at(0.2, 1.9, -0.3), Rgb.WHITE, Emission.intensity(Rgb.gray(3))), method);
    }
}
