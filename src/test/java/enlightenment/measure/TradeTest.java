package enlightenment.measure;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.color.Color;
import enlightenment.image.Image;
import enlightenment.image.ImageError;
import enlightenment.math.InvalidValueException;
import enlightenment.measure.trade.Advice;
import enlightenment.measure.trade.Reference;
import enlightenment.measure.trade.Sweep;
import enlightenment.measure.trade.TradeListener;
import enlightenment.measure.trade.TradeResult;
import enlightenment.measure.trade.TradeRun;
import enlightenment.measure.trade.TradeSettings;
import enlightenment.render.Renderer;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.Method;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.Shading;
import enlightenment.scene.json.SceneReader;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** With a budget that is over at once the fewest renders are made, whatever they take: nothing here depends on time. */
class TradeTest {
    private static final double NO_TIME = 1e-9;

    @TempDir
    Path folder;

    private final Scene scene = SceneReader.readString(
            """
            { "image": { "width": 12, "height": 8 },
              "camera": { "type": "perspective", "eye": [0, 0, -5], "lookAt": [0, 0, 0], "up": [0, 1, 0], "fieldOfView": 40 },
              "materials": { "white": { "type": "matte", "color": "#ffffff" } },
              "lights": [ { "type": "sphere", "center": [2, 3, -2], "radius": 0.5, "color": "#ffffff" } ],
              "objects": [ { "type": "sphere", "center": [0, 0, 0], "radius": 1, "material": "white" },
                           { "type": "sphere", "center": [0, -101, 0], "radius": 100, "material": "white" } ] }
            """,
            Path.of("."),
            "the test's scene");

    private final TradeSettings settings = TradeSettings.of(
                    RenderSettings.of(scene).withThreads(1), scene.shading().model(), "two balls")
            .withMethods(List.of("raytrace", "cluster"))
            .withBudgetSeconds(NO_TIME)
            .withSeeds(2);

    private Optional<TradeResult> run(TradeSettings what, boolean resume) throws IOException {
        return Trade.run(scene, what, folder, resume, TradeListener.NONE, () -> false);
    }

    private static Set<Double> budgets(TradeResult result, String method) {
        return result.runs().stream()
                .filter(r ->
                        r.kind().equals(TradeRun.BUDGET_SERIES) && r.method().equals(method))
                .map(TradeRun::samples)
                .collect(Collectors.toSet());
    }

    @Test
    void eachMethodRendersTheFirstBudgetsWhateverTheyTake() throws IOException {
        TradeResult result = run(settings, false).orElseThrow();
        assertTrue(result.conditions().complete());
        assertEquals(settings, result.settings());
        assertEquals(2, result.reference().parts().size());
        assertEquals(Set.of(1.0, 2.0, 2.5, 4.0), budgets(result, "raytrace"));
        // Below that its pictures are those of the other one.
        assertEquals(Set.of(2.5, 4.0), budgets(result, "cluster"));
        assertTrue(result.runs().stream().allMatch(r -> r.wallSeconds() > 0 && r.samplesPerPixel() > 0));
    }

    /** An open room without mirrors: all of them see it, and each begins where no other takes its place. */
    @Test
    void allMethodsThatCanRenderTheSceneAreCompared() throws IOException {
        Scene room = SceneReader.read(Path.of("src/test/resources/physical/cornell.json"));
        RenderSettings base = RenderSettings.of(room).withSize(8, 8).withThreads(1);
        TradeSettings what = TradeSettings.of(base, room.shading().model(), "a room")
                .withBudgetSeconds(NO_TIME)
                .withSeeds(1);
        TradeResult result = Trade.run(room, what, folder, false, TradeListener.NONE, () -> false)
                .orElseThrow();
        assertEquals(Method.words(BuiltInMethod.rendering(Shading.Model.PHYSICAL)), what.methods());
        assertEquals(what.methods(), result.sightedMethods());
        for (Renderer.Sight sight : Renderer.inspect(room, base).methods()) {
            Set<Double> rendered = budgets(result, sight.method().word());
            // Those from outside want to be named.
            assertEquals(what.methods().contains(sight.method().word()), rendered.size() >= 2, rendered.toString());
            assertTrue(rendered.stream().allMatch(n -> n >= sight.fewestSamples()), rendered.toString());
        }
        // One picture of each, whatever the time.
        assertEquals(
                Set.copyOf(what.methods()),
                result.runs().stream()
                        .filter(r -> r.kind().equals(TradeRun.EQUAL_TIME))
                        .map(TradeRun::method)
                        .collect(Collectors.toSet()));
    }

    /** A ring of mirror, a ball of glass: what is seen in them, paths from lights do not show. */
    @Test
    void theReferenceIsMadeByWhatSeesAllOfTheScene() throws IOException {
        Scene room = SceneReader.read(Path.of("scenes/caustics.json"));
        RenderSettings base = RenderSettings.of(room).withSize(8, 8).withThreads(1);
        TradeSettings what = TradeSettings.of(base, room.shading().model(), "a room")
                .withMethods(List.of("light", "cluster"))
                .withBudgetSeconds(NO_TIME)
                .withSeeds(1);
        TradeResult result = Trade.run(room, what, folder, false, TradeListener.NONE, () -> false)
                .orElseThrow();
        assertEquals(Set.of("light"), result.blindSpots().keySet());
        assertEquals(List.of("cluster"), result.sightedMethods());
        assertEquals(
                List.of("cluster", "cluster"),
                result.reference().parts().stream().map(Reference.Part::method).toList());
        assertEquals(
                2,
                result.reference().parts().stream()
                        .map(Reference.Part::seed)
                        .distinct()
                        .count());
        assertEquals(Set.of(1.0, 2.0, 2.5, 4.0), budgets(result, "light"));
        assertEquals(Set.of(8.0, 16.0), budgets(result, "cluster"));
        assertEquals(result.blindSpots(), Trade.read(room, what, folder).blindSpots());
        // If nothing else is compared, path tracing makes the reference.
        TradeResult alone = Trade.run(
                        room,
                        what.withMethods(List.of("light")),
                        folder.resolve("alone"),
                        false,
                        TradeListener.NONE,
                        () -> false)
                .orElseThrow();
        assertEquals("raytrace", alone.reference().parts().get(0).method());
        assertEquals(Advice.Basis.NOTHING, Trade.advice(alone, 1).basis());
    }

    @Test
    void aFolderIsReadAsItWasMeasured() throws IOException {
        TradeResult result = run(settings, false).orElseThrow();
        TradeResult read = Trade.read(scene, settings, folder);
        assertEquals(result.runs(), read.runs());
        assertEquals(result.reference().variance(), read.reference().variance());
        assertEquals(result.conditions(), read.conditions());
        assertEquals(Trade.advice(result, 0.01), Trade.advice(read, 0.01));
    }

    @Test
    void ofPhysicalLightErrorsAreThoseOfWhatIsShown() throws IOException {
        Scene room = SceneReader.read(Path.of("src/test/resources/physical/cornell.json"));
        RenderSettings base = RenderSettings.of(room).withSize(12, 12).withThreads(1);
        TradeSettings what = TradeSettings.of(base, room.shading().model(), "a room")
                .withMethods(List.of("raytrace"))
                .withBudgetSeconds(NO_TIME)
                .withSeeds(1);
        TradeResult result = Trade.run(room, what, folder, false, TradeListener.NONE, () -> false)
                .orElseThrow();
        Image reference = result.reference().image();
        assertEquals(Color.Encoding.LINEAR, reference.encoding());
        TradeRun run = result.runs().stream()
                .filter(r -> r.kind().equals(TradeRun.BUDGET_SERIES))
                .findFirst()
                .orElseThrow();
        Image again = Renderer.render(
                room,
                base.withMethod(Method.RAYTRACE)
                        .withSeed(run.seed())
                        .withBudget(RenderSettings.Budget.NONE.withSamples(run.samples())));
        assertEquals(
                ImageError.between(again.toDisplay(), reference.toDisplay()).meanSquaredError(),
                run.meanSquaredDifference());
        Image read = Trade.read(room, what, folder).reference().image();
        assertEquals(reference.curve(), read.curve());
        assertArrayEquals(reference.toArray(), read.toArray());
    }

    @Test
    void aFolderIsResumedOnlyOnRequestAndWithTheSameSettings() throws IOException {
        List<TradeRun> first = run(settings, false).orElseThrow().runs();
        assertEquals("output", refusal(settings, false));
        assertEquals("resume", refusal(settings.withMethods(List.of("cluster")), true));
        TradeSettings more = settings.withSweeps(List.of(Sweep.parse("shadowSamples=1..4")));
        List<TradeRun> all = run(more, true).orElseThrow().runs();
        assertEquals(first, all.subList(0, first.size()));
        // The first two values of a sweep come in any case, with one seed.
        assertEquals(
                List.of(1, 2),
                all.stream()
                        .filter(r -> r.kind().equals(TradeRun.SWEEP + "shadowSamples"))
                        .map(TradeRun::shadowSamples)
                        .toList());
    }

    private String refusal(TradeSettings what, boolean resume) {
        return assertThrows(InvalidValueException.class, () -> run(what, resume))
                .key();
    }

    @Test
    void cancelledAtOnceThereIsNothingAndLaterThereIsWhatWasMeasured() throws IOException {
        assertTrue(Trade.run(scene, settings, folder, false, TradeListener.NONE, () -> true)
                .isEmpty());
        List<String> steps = new ArrayList<>();
        TradeListener listener = (step, done, total) -> {
            assertTrue(done <= total);
            synchronized (steps) {
                steps.add(step);
            }
        };
        TradeResult cut = Trade.run(scene, settings, folder, true, listener, () -> {
                    synchronized (steps) {
                        return steps.contains("4 samples per pixel");
                    }
                })
                .orElseThrow();
        assertFalse(cut.conditions().complete());
        assertEquals(Set.of(1.0, 2.0, 2.5), budgets(cut, "raytrace"));
        assertEquals("warming up", steps.get(0));
    }

    @Test
    void adviceIsWhatTheRunsTell() throws IOException {
        TradeResult result = run(settings, false).orElseThrow();
        // Every method was measured to reach the largest error of any of its runs.
        double reached = result.runs().stream()
                .mapToDouble(r -> r.error(result.reference().variance()))
                .max()
                .orElseThrow();
        Advice advice = Trade.advice(result, reached);
        assertEquals(Advice.Basis.MEASURED, advice.basis());
        assertTrue(advice.settings().orElseThrow().budget().samples().orElseThrow() >= 1);
        assertEquals(Advice.Basis.NOTHING, Trade.advice(result, 1e-12).basis());
    }
}
