package enlightenment.render;

import enlightenment.device.share.PreparedDevice;
import enlightenment.engine.FilmPlace;
import enlightenment.engine.TilePicture;
import enlightenment.film.Film;
import enlightenment.plan.Planner;
import enlightenment.plan.RenderPlan;
import enlightenment.report.RenderReport;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.json.SceneReader;
import enlightenment.work.Phases;
import enlightenment.work.Stopwatch;
import enlightenment.world.CompiledScene;
import enlightenment.world.SceneCompiler;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.IntStream;

/** The same picture with one seed after another, in full precision. */
final class ManySeeds {
    private ManySeeds() {}

    static Scene shipped(String name) {
        return SceneReader.read(Path.of(System.getProperty("project.directory"), "scenes", name + ".json"));
    }

    /** A finished render in doubles, with its report. */
    record Picture(double[] rgb, int[] counts, Film film, RenderReport report, RenderPlan plan) {
        RenderReport.Sampling sampling() {
            return report.sampling();
        }
    }

    static Picture render(CompiledScene compiled, RenderSettings settings) {
        RenderPlan plan = new Planner(compiled, settings, () -> false).plan(Stopwatch.started(), 0);
        return render(compiled, settings, plan);
    }

    /** A render in memory, by the processor alone, that is done. */
    static LocalRender finished(CompiledScene compiled, RenderSettings settings, RenderPlan plan) {
        LocalRender render = new LocalRender(
                "",
                compiled,
                settings,
                plan,
                RenderProgress.NONE,
                () -> false,
                null,
                FilmPlace.MEMORY,
                PreparedDevice.NONE);
        render.run();
        return render;
    }

    static Picture render(CompiledScene compiled, RenderSettings settings, RenderPlan plan) {
        LocalRender render = finished(compiled, settings, plan);
        Film film = ((TilePicture) render.film()).film();
        RenderSettings.Crop region = settings.region();
        double[] rgb = new double[3 * region.width() * region.height()];
        int[] counts = new int[rgb.length / 3];
        for (int i = 0; i < rgb.length; i++) {
            int x = region.x() + i / 3 % region.width();
            int y = region.y() + i / 3 / region.width();
            rgb[i] = film.component(x, y, i % 3);
            counts[i / 3] = film.count(x, y);
        }
        return new Picture(rgb, counts, film, render.report(new Phases(), 0, 1), plan);
    }

    /** What a render reports of its samples, also of pictures that light paths are splatted over. */
    static RenderReport.Sampling sampling(Scene scene, RenderSettings settings) {
        CompiledScene compiled = SceneCompiler.compile(scene, settings);
        RenderPlan plan = new Planner(compiled, settings, () -> false).plan(Stopwatch.started(), 0);
        LocalRender render = finished(compiled, settings, plan);
        return render.report(new Phases(), 0, 1).sampling();
    }

    static Picture render(Scene scene, RenderSettings settings) {
        return render(SceneCompiler.compile(scene, settings), settings);
    }

    /** Pictures with the seeds first, first + 1, … */
    static List<Picture> render(Scene scene, RenderSettings settings, long first, int count) {
        CompiledScene compiled = SceneCompiler.compile(scene, settings);
        return IntStream.range(0, count)
                .parallel()
                .mapToObj(k -> render(compiled, settings.withThreads(1).withSeed(first + k)))
                .toList();
    }
}
