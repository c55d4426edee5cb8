package enlightenment.cli.film;

import static org.junit.jupiter.api.Assertions.assertEquals;

import enlightenment.render.RenderProgress;
import enlightenment.render.Renderer;
import enlightenment.report.RenderReport;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.json.SceneReader;
import java.nio.file.Path;
import java.util.Map;
import org.junit.jupiter.api.Test;

class FilmReportTest {
    /** The report of a picture with so many rays of each of two kinds. */
    private static RenderReport report(long rays) {
        Scene scene = SceneReader.read(Path.of("src/test/resources/physical/cornell.json"));
        RenderSettings settings =
                RenderSettings.of(scene).withSize(1, 1).withBudget(RenderSettings.Budget.NONE.withSamples(1));
        RenderReport r = Renderer.render(scene, settings, RenderProgress.NONE, () -> false)
                .report();
        return new RenderReport(
                r.sceneName(),
                r.settings(),
                r.features(),
                Map.of("camera", rays, "shadow", rays),
                r.lightSamples(),
                r.lightSamplesWithoutRay(),
                r.sampling(),
                r.testsByPrimitive(),
                r.hitsByPrimitive(),
                r.textureLookups(),
                r.phases(),
                r.pixels(),
                r.peakMemoryBytes());
    }

    @Test
    void theRaysOfAllFramesAreAddedAsFarAsNumbersGo() {
        assertEquals(14, FilmReport.rays(Map.of(0, report(3), 7, report(4))));
        RenderReport many = report(1L << 61);
        assertEquals(1L << 62, many.rays());
        assertEquals(Long.MAX_VALUE, FilmReport.rays(Map.of(0, many, 1, many, 2, many)));
        assertEquals(Long.MAX_VALUE, report(1L << 62).rays());
    }
}
