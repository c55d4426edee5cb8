package enlightenment.bench;

import enlightenment.film.FilmTile;
import enlightenment.method.TileIntegrator;
import enlightenment.plan.Integrators;
import enlightenment.plan.Planner;
import enlightenment.plan.RenderPlan;
import enlightenment.scene.Method;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.json.SceneReader;
import enlightenment.world.CompiledScene;
import enlightenment.world.SceneCompiler;
import enlightenment.world.parts.RayCounters;
import java.nio.file.Path;
import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

/** A tile of 64 × 64 pixels in the middle of the picture, with 16 samples per pixel in the mean, by each method. */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MILLISECONDS)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
@Fork(1)
public class TileBenchmark {
    private static final int SIDE = 64;
    private static final double SAMPLES = 16;

    @Param({"raytrace", "cluster"})
    public String method;

    @Param({"fire-and-ice", "keyhole"})
    public String scene;

    private TileIntegrator tileMethod;

    @Setup
    public void setUp() {
        Scene read = SceneReader.read(Path.of("scenes", scene + ".json"));
        RenderSettings settings =
                RenderSettings.of(read).withMethod(Method.named(method)).withThreads(1);
        CompiledScene compiled = SceneCompiler.compile(read, settings);
        RenderPlan plan = new Planner(compiled, settings, () -> false).withSamples(SAMPLES, "samples");
        tileMethod =
                (TileIntegrator) Integrators.of(plan, compiled, settings, new RayCounters(compiled.kindNames.size()));
    }

    @Benchmark
    public FilmTile tile() {
        FilmTile all = null;
        // In the tiles that a render is cut into.
        for (int y = 0; y < SIDE; y += FilmTile.BLOCK_SIDE) {
            for (int x = 0; x < SIDE; x += FilmTile.BLOCK_SIDE) {
                FilmTile tile = new FilmTile(368 + x, 168 + y, FilmTile.BLOCK_SIDE, FilmTile.BLOCK_SIDE);
                tileMethod.render(tile);
                all = tile;
            }
        }
        return all;
    }
}
