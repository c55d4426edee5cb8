package enlightenment.cli.picture;

import static org.junit.jupiter.api.Assertions.assertDoesNotThrow;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.cli.terminal.CliException;
import enlightenment.cli.terminal.ExitCode;
import enlightenment.color.Color;
import enlightenment.color.DisplayCurve;
import enlightenment.image.Image;
import enlightenment.render.RenderProgress;
import enlightenment.render.RenderResult;
import enlightenment.render.Renderer;
import enlightenment.report.RenderReport;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.json.SceneReader;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;

class LightNotesTest {
    /** A finished render whose report says that some samples were no numbers. */
    private static RenderResult result(long lost) throws Exception {
        Scene scene = SceneReader.read(Path.of("src/test/resources/physical/cornell.json"));
        RenderSettings settings =
                RenderSettings.of(scene).withSize(8, 8).withBudget(RenderSettings.Budget.NONE.withSamples(4));
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
        assertTrue(ReportJson.of(bad, Optional.empty(), Optional.empty())
                .replace(" ", "")
                .contains("\"lostSamples\":3"));
        RenderResult good = result(0);
        assertDoesNotThrow(() -> LightNotes.require(good, good.image()));
    }

    @Test
    void lightBeyondTheRangeOfFloatsFailsTheCommandAndIsTold() throws Exception {
        RenderResult good = result(0);
        Image bright = new Image(1, 1, new float[] {1, Float.POSITIVE_INFINITY, 2}, Color.Encoding.LINEAR);
        CliException e = assertThrows(CliException.class, () -> LightNotes.require(good, bright));
        assertTrue(
                e.getMessage().startsWith("1 numbers of the picture are beyond the range of floats"), e.getMessage());
    }

    /** A worker that lies may send sums which are finite, and whose own sum is not. */
    @Test
    void whatIsNoNumberFailsTheCommandWhateverThePictureIsOf() throws Exception {
        RenderResult good = result(0);
        for (Color.Encoding encoding : Color.Encoding.values()) {
            Image bad = new Image(1, 2, new float[] {0, Float.NaN, 0, 0, Float.NaN, 0}, encoding);
            CliException e = assertThrows(CliException.class, () -> LightNotes.require(good, bad));
            assertEquals(ExitCode.FAILED, e.exitCode());
            assertTrue(e.getMessage().startsWith("2 numbers of the picture are no numbers"), e.getMessage());
            List<String> told = new ArrayList<>();
            BrightnessHint.tell(bad, false, (kind, line) -> told.add(line));
            assertEquals(List.of(), told, "that it is dark says less");
        }
    }

    private static Image image(double exposure, double value) {
        return new Image(1, 1, new float[] {0, (float) value, 0}, DisplayCurve.SRGB.withExposure(exposure));
    }

    /**
     * Numbers near 0 are 2⁻¹⁴⁹ apart. The curve's slope is 12.92 there, so that they are seen 12.92·2^(E − 149) apart: a step of 8 bits,
     * 1/255, at E = 137.3.
     */
    @Test
    void lightBelowTheRangeOfFloatsFailsTheCommandWhereTheExposureShowsIt() throws Exception {
        RenderResult good = result(0);
        double few = 4 * Float.MIN_VALUE;
        for (double exposure : new double[] {-1000, 0, 100, 137}) {
            assertDoesNotThrow(() -> LightNotes.require(good, image(exposure, few)));
        }
        CliException e = assertThrows(CliException.class, () -> LightNotes.require(good, image(138, few)));
        assertTrue(e.getMessage().startsWith("1 numbers of the picture are below the range of floats"), e.getMessage());
        assertTrue(e.getMessage().endsWith("2^138 times as much, and the exposure 138 less"), e.getMessage());
        // Nothing, and what is normal or white, is as it should be at any exposure.
        assertDoesNotThrow(() -> LightNotes.require(good, image(1000, 0)));
        assertDoesNotThrow(() -> LightNotes.require(good, image(1000, 1)));
        assertDoesNotThrow(() -> LightNotes.require(good, image(125, Float.MIN_NORMAL)));
    }

    @Test
    void whatOneSampleDoesNotTellIsLeftOut() throws Exception {
        Scene scene = SceneReader.read(Path.of("src/test/resources/physical/cornell.json"));
        for (double samples : new double[] {1, 4}) {
            RenderSettings settings =
                    RenderSettings.of(scene).withSize(8, 8).withBudget(RenderSettings.Budget.NONE.withSamples(samples));
            String stats = StatsTable.of(Renderer.render(scene, settings, RenderProgress.NONE, () -> false)
                    .report());
            assertEquals(samples > 1, stats.contains("of linear light"), stats);
            assertFalse(stats.contains("NaN"), stats);
        }
    }

    @Test
    void theStatisticsCallTheErrorOfFewSamplesAGuess() throws Exception {
        Scene scene = SceneReader.read(Path.of("src/test/resources/physical/cornell.json"));
        for (int samples = 1; samples <= 4; samples++) {
            RenderSettings settings =
                    RenderSettings.of(scene).withSize(8, 8).withBudget(RenderSettings.Budget.NONE.withSamples(samples));
            RenderResult r = Renderer.render(scene, settings, RenderProgress.NONE, () -> false);
            assertEquals(samples < 4, StatsTable.of(r.report()).contains("a guess"), samples + " samples per pixel");
        }
    }
}
