package enlightenment.bench;

import enlightenment.image.Image;
import enlightenment.render.Renderer;
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
import org.openjdk.jmh.annotations.OperationsPerInvocation;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

/** What a path of plain fire and ice takes in a small picture: by what renders, and written into the code ({@link FlatRoom}). */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@OperationsPerInvocation(FlatRoomBenchmark.PATHS)
@Warmup(iterations = 5, time = 1)
@Measurement(iterations = 5, time = 1)
@Fork(1)
public class FlatRoomBenchmark {
    private static final int WIDTH = 96;
    private static final int HEIGHT = 48;
    private static final int SAMPLES = 16;
    static final int PATHS = WIDTH * HEIGHT * SAMPLES;

    private final FlatRoom room = new FlatRoom();
    private Scene scene;
    private RenderSettings settings;

    @Setup
    public void setUp() {
        scene = SceneReader.read(Path.of("src", "bench", "scenes", "fire-and-ice-plain-physical.json"));
        settings = RenderSettings.of(scene).withThreads(1);
    }

    /** As {@code render --samples 16 --threads 1} does it: film, error and caustics are part of it. */
    @Benchmark
    public Image raytrace() {
        return Renderer.render(scene, settings);
    }

    @Benchmark
    public double flat() {
        return room.mean(WIDTH, HEIGHT, SAMPLES);
    }
}
