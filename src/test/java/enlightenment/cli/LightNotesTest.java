package enlightenment.cli;

import static org.junit.jupiter.api.Assertions.assertDoesNotThrow;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.color.Encoding;
import enlightenment.image.Image;
import enlightenment.render.RenderProgress;
import enlightenment.render.RenderResult;
import enlightenment.render.Renderer;
import enlightenment.report.RenderReport;
import enlightenment.scene.Budget;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.json.SceneReader;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;

class LightNotesTest {
    /** A finished render whose report says that some samples were no numbers. */
    private static RenderResult result(long lost) throws Exception {
        Scene scene = SceneReader.read(Path.of("src/test/resources/physical/cornell.json"));
        RenderSettings settings = RenderSettings.of(scene).withSize(8, 8).withBudget(Budget.NONE.withSamples(4));
        RenderResult r = Renderer.render(scene, settings, RenderProgress.NONE, () -> false);
        RenderReport p = r.report();
        RenderReport.Sampling s = p.sampling();
        RenderReport.Sampling told = new RenderReport.Sampling(
                s.method(),
                s.decidedBy(),
                s.plannedSamples(),
                s.samplesPerPixel(),
                s.estimatedError(),
                s.errorLow(),
                s.errorHigh(),
                s.clusters(),
                s.proposals(),
                s.accepted(),
                s.rounding(),
                s.rounds(),
                Optional.of(new RenderReport.Light(0.1, 3, false, lost)));
        RenderReport report = new RenderReport(
                p.sceneName(),
                p.settings(),
                p.features(),
                p.raysByKind(),
                p.lightSamples(),
                p.lightSamplesWithoutRay(),
                told,
                p.testsByPrimitive(),
                p.hitsByPrimitive(),
                p.textureLookups(),
                p.phases(),
                p.pixels(),
                p.peakMemoryBytes());
        return new RenderResult(r.image(), report, true, r.shownPixels(), Map.of(), List.of());
    }

    @Test
    void samplesThatAreNoNumbersFailTheCommandAndAreTold() throws Exception {
        RenderResult bad = result(3);
        CliException e = assertThrows(CliException.class, () -> LightNotes.require(bad, bad.image()));
        assertTrue(e.getMessage().startsWith("3 samples were infinite or no numbers"), e.getMessage());
        assertTrue(StatsTable.of(bad.report()).contains("lost samples"));
        assertTrue(ReportJson.of(bad).replace(" ", "").contains("\"lostSamples\":3"));
        RenderResult good = result(0);
        assertDoesNotThrow(() -> LightNotes.require(good, good.image()));
    }

    @Test
    void lightBeyondTheRangeOfFloatsFailsTheCommandAndIsTold() throws Exception {
        RenderResult good = result(0);
        Image bright = new Image(1, 1, new float[] {1, Float.POSITIVE_INFINITY, 2}, Encoding.LINEAR);
        CliException e = assertThrows(CliException.class, () -> LightNotes.require(good, bright));
        assertTrue(
                e.getMessage().startsWith("1 numbers of the picture are beyond the range of floats"), e.getMessage());
    }

    @Test
    void whatOneSampleDoesNotTellIsLeftOut() throws Exception {
        Scene scene = SceneReader.read(Path.of("src/test/resources/physical/cornell.json"));
        for (double samples : new double[] {1, 4}) {
            RenderSettings settings =
                    RenderSettings.of(scene).withSize(8, 8).withBudget(Budget.NONE.withSamples(samples));
            String stats = StatsTable.of(Renderer.render(scene, settings, RenderProgress.NONE, () -> false)
                    .report());
            assertEquals(samples > 1, stats.contains("of linear light"), stats);
            assertFalse(stats.contains("NaN"), stats);
        }
    }
}
