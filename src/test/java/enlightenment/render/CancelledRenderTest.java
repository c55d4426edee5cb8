package enlightenment.render;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.engine.DividedRender;
import enlightenment.engine.UnitMaker;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.Method;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.Shading;
import enlightenment.scene.json.SceneReader;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Every phase of a render of which a single tile takes hours ends soon after it is cancelled. */
@Timeout(600)
class CancelledRenderTest {
    /** A closed ball of mirror, seen from within: every path goes on to its last bounce. */
    private static final String SCENE =
            """
            {
              "image": { "width": 256, "height": 256 },
              "camera": { "type": "perspective", "eye": [0.1, 0.2, 0], "lookAt": [1, 0, 0], "up": [0, 1, 0],
                          "fieldOfView": 40 },
              "shading": { "maxBounces": 1000000 },
              "materials": { "wall": { "type": "mirror", "color": "#ffffff" } },
              "lights": [ { "type": "point", "position": [0, 0.5, 0], "color": "#ffffff" } ],
              "objects": [ { "type": "sphere", "center": [0, 0, 0], "radius": 1, "material": "wall" } ]
            }
            """;

    private static final List<RenderSettings.Budget> BUDGETS = List.of(
            RenderSettings.Budget.NONE,
            RenderSettings.Budget.NONE.withSamples(16),
            RenderSettings.Budget.NONE.withError(0.01),
            RenderSettings.Budget.NONE.withSeconds(1e6));

    private final Scene scene = SceneReader.readString(SCENE, Path.of("."), "");

    @Test
    void whateverIsPlannedOrRendered() {
        for (Method method : BuiltInMethod.rendering(Shading.Model.CLASSIC)) {
            for (RenderSettings.Budget budget : BUDGETS) {
                for (int patience : new int[] {1, 7, 60}) {
                    AtomicInteger asked = new AtomicInteger();
                    RenderSettings settings = RenderSettings.of(scene)
                            .withMethod(method)
                            .withBudget(budget)
                            .withThreads(2);
                    RenderResult result = Renderer.render(RenderRequest.of(scene, settings)
                            .withProgressive(patience == 7)
                            .withCancelled(() -> asked.incrementAndGet() >= patience));
                    assertFalse(result.complete());
                    assertEquals(0, result.report().pixels(), method + " " + budget);
                }
            }
        }
    }

    @Test
    void aTileThatIsMadeElsewhere() {
        RenderSettings settings = RenderSettings.of(scene).withThreads(1);
        DividedRender render = DividedRender.prepare(scene, settings, () -> false);
        AtomicInteger asked = new AtomicInteger();
        UnitMaker maker = render.maker(() -> asked.incrementAndGet() >= 3);
        assertThrows(CancellationException.class, () -> maker.make(0));
        assertTrue(asked.get() >= 3);
    }
}
