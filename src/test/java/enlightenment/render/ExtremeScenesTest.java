package enlightenment.render;

import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.Method;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.SceneException;
import enlightenment.scene.json.SceneReader;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** Whatever numbers a scene is made of, it is refused with a reason, or its picture is made of numbers. */
class ExtremeScenesTest {
    private int refused;
    private int rendered;

    @Test
    void extremeScenesAreRefusedOrRendered() {
        // About a quarter are refused: 80 of 400 is three standard deviations below.
        run(1, 400);
        assertTrue(refused > 80 && rendered > 80, refused + " refused, " + rendered + " rendered");
    }

    @Test
    @Tag("full")
    void manyExtremeScenesAreRefusedOrRendered() {
        run(2, 50_000);
    }

    private void run(long seed, int count) {
        ExtremeScenes scenes = new ExtremeScenes(seed);
        List<String> faults = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            String text = scenes.next();
            String fault = fault(text, i % 4 == 0 ? Method.CLUSTER : Method.RAYTRACE);
            if (!fault.isEmpty()) {
                faults.add(fault + "\n" + text);
            }
        }
        assertTrue(
                faults.isEmpty(),
                () -> faults.size() + " faults; " + String.join("\n", faults.subList(0, Math.min(faults.size(), 5))));
    }

    /** What is wrong with how a text is treated; empty if nothing is. */
    private String fault(String text, Method method) {
        try {
            Scene scene = SceneReader.readString(text, Path.of("."), "extreme");
            RenderSettings settings = RenderSettings.of(scene)
                    .withMethod(method)
                    .withAntialias(1)
                    .with(new BuiltInMethod.RayTraceSettings(2))
                    .withThreads(1);
            for (double c : RawPicture.of(scene, settings).rgb()) {
                if (!(c >= 0 && c <= 1 + 1e-9)) {
                    return "a colour is " + c;
                }
            }
            Renderer.inspect(scene, settings);
            rendered++;
            return "";
        } catch (SceneException e) {
            refused++;
            return "";
        } catch (RuntimeException e) {
            StringBuilder s = new StringBuilder(e.toString());
            for (int k = 0; k < Math.min(6, e.getStackTrace().length); k++) {
                s.append("\n  at ").append(e.getStackTrace()[k]);
            }
            return s.toString();
        }
    }
}
