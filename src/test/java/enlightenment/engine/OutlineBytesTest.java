package enlightenment.engine;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.camera.Camera;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.plan.RenderPlan;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.ChosenSettings;
import enlightenment.scene.Method;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.ToyMethod;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Settings as bytes: those of the method in use, whichever it is, and no others. */
class OutlineBytesTest {
    private static final RenderSettings SETTINGS = RenderSettings.of(Scene.builder()
                    .camera(new Camera.Perspective(ExactPoint.ORIGIN, ExactPoint.of(0, 0, 1), new Vec3(0, 1, 0), 40))
                    .build())
            .withThreads(1);

    private static byte[] bytes(RenderSettings s) throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        OutlineBytes.write(new DataOutputStream(bytes), s, new RenderPlan(s.method(), 1, 4, "samples"));
        return bytes.toByteArray();
    }

    private static RenderSettings again(byte[] bytes) throws IOException {
        return OutlineBytes.read(new DataInputStream(new ByteArrayInputStream(bytes)), 1)
                .settings();
    }

    @Test
    void theSettingsOfEachMethodArriveAndThoseOfAMethodFromOutsideToo() throws IOException {
        RenderSettings s = SETTINGS.using(new BuiltInMethod.RayTraceSettings(3));
        assertEquals(s, again(bytes(s)));
        s = s.using(new BuiltInMethod.ClusterSettings("zeta"));
        assertEquals(s, again(bytes(s)));
        s = SETTINGS.using(new ToyMethod.Settings(5, "square"));
        assertEquals(s, again(bytes(s)));
    }

    @Test
    void theSettingsThatAllMethodsHaveArrive() throws IOException {
        RenderSettings s = SETTINGS;
        for (Method.Setting setting : ChosenSettings.Common.ALL) {
            s = s.with(
                    setting, setting instanceof Method.Setting.Whole w ? w.max() : last((Method.Setting.Word) setting));
            assertEquals(s, again(bytes(s)));
        }
    }

    private static Object last(Method.Setting.Word setting) {
        return setting.words().get(setting.words().size() - 1);
    }

    /** Statistics show them as they are, of files from anybody too. */
    @Test
    void wordsThatSaySomethingToTerminalsAreRefused() throws IOException {
        for (boolean isKind : new boolean[] {false, true}) {
            RenderPlan plan = new RenderPlan(SETTINGS.method(), 1, 4, isKind ? "samples" : "samples\u001b[2J");
            List<String> kinds = List.of(isKind ? "sphere\u001b[2J" : "sphere");
            ByteArrayOutputStream bytes = new ByteArrayOutputStream();
            OutlineBytes.write(
                    new DataOutputStream(bytes), new RenderOutline("a scene", SETTINGS, plan, List.of(), kinds));
            DataInputStream in = new DataInputStream(new ByteArrayInputStream(bytes.toByteArray()));
            assertThrows(IllegalArgumentException.class, () -> OutlineBytes.readOutline(in, 1));
        }
    }

    /** Bytes are hashed, and a picture that does not depend on something has one hash. */
    @Test
    void whatTheMethodDoesNotLookAtIsNotInTheBytes() throws IOException {
        RenderSettings s = SETTINGS.using(new BuiltInMethod.RayTraceSettings(3));
        assertArrayEquals(bytes(s), bytes(s.with(new BuiltInMethod.ClusterSettings("zeta"))));
        assertArrayEquals(bytes(s), bytes(s.with(ToyMethod.RAYS, 5)));
        // With too few samples cluster is raytrace.
        RenderSettings c = s.withMethod(Method.CLUSTER);
        assertTrue(!java.util.Arrays.equals(bytes(c), bytes(c.with(new BuiltInMethod.RayTraceSettings(4)))));
    }

    @Test
    void settingsThatTheMethodDoesNotHaveAreRefused() throws IOException {
        String text =
                new String(bytes(SETTINGS.using(new BuiltInMethod.RayTraceSettings(3))), StandardCharsets.ISO_8859_1);
        for (String wrong : new String[] {"shadowSampler", "SHADOWSAMPLES"}) {
            byte[] bytes = text.replace("shadowSamples", wrong).getBytes(StandardCharsets.ISO_8859_1);
            assertThrows(IllegalArgumentException.class, () -> again(bytes), wrong);
        }
        byte[] zero = text.replace("\0\0\0\0013", "\0\0\0\0010").getBytes(StandardCharsets.ISO_8859_1);
        assertThrows(IllegalArgumentException.class, () -> again(zero));
        byte[] word = text.replace("\0\0\0\0013", "\0\0\0\001x").getBytes(StandardCharsets.ISO_8859_1);
        assertThrows(IllegalArgumentException.class, () -> again(word));
    }
}
