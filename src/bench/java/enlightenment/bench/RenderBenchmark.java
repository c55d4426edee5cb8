package enlightenment.bench;

import enlightenment.image.Image;
import enlightenment.render.Renderer;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.json.SceneReader;
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

/** A shipped scene, warm, on one thread: 200 × 100 pixels with 4 × 4 positions and 10 shadow samples. */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MILLISECONDS)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
@Fork(1)
public class RenderBenchmark {
    @Param({"fire-and-ice", "cylinders", "cone", "cube", "primitives", "glass", "torus"})
    public String scene;

    private Scene read;
    private RenderSettings settings;

    @Setup
    public void setUp() {
        read = SceneReader.read(Path.of("scenes", scene + ".json"));
        settings = RenderSettings.of(read)
                .withSize(200, 100)
                .withAntialias(4)
                .with(new BuiltInMethod.RayTraceSettings(10))
                .withThreads(1);
    }

    @Benchmark
    public Image render() {
        return Renderer.render(read, settings);
    }
}
