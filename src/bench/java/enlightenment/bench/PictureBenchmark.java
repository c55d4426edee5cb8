package enlightenment.bench;

import enlightenment.film.Film;
import enlightenment.film.FilmTile;
import enlightenment.image.Image;
import enlightenment.image.ImageFiles;
import enlightenment.render.Renderer;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.json.SceneReader;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

/** What surrounds the tracing, for 800 × 400 pixels: adding samples, putting tiles together, the picture, PNG, reading. */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MILLISECONDS)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
@Fork(1)
public class PictureBenchmark {
    private static final int WIDTH = 800;
    private static final int HEIGHT = 400;
    private static final int SIDE = 8;

    private Film film;
    private Image image;
    private Path file;

    @Setup
    public void setUp() throws IOException {
        film = new Film(0, 0, WIDTH, HEIGHT);
        filmFromTiles();
        file = Path.of("scenes", "fire-and-ice.json");
        Scene scene = SceneReader.read(file);
        image = Renderer.render(scene, RenderSettings.of(scene).withAntialias(2));
        // So that the first read is not the one from the disk.
        Files.readString(file, StandardCharsets.UTF_8);
    }

    /** One sample for each pixel, and all tiles into the film. */
    @Benchmark
    public Film filmFromTiles() {
        for (int y = 0; y < HEIGHT; y += SIDE) {
            for (int x = 0; x < WIDTH; x += SIDE) {
                FilmTile tile = new FilmTile(x, y, SIDE, SIDE);
                for (int j = y; j < y + SIDE; j++) {
                    for (int i = x; i < x + SIDE; i++) {
                        tile.add(i, j, 0.25, 0.5, 0.75);
                    }
                }
                film.put(tile);
            }
        }
        return film;
    }

    @Benchmark
    public Image imageFromFilm() {
        return film.toImage();
    }

    @Benchmark
    public void png() throws IOException {
        ImageFiles.toPng(image, OutputStream.nullOutputStream(), new ImageFiles.PngOptions(8, Map.of()));
    }

    @Benchmark
    public void png16() throws IOException {
        ImageFiles.toPng(image, OutputStream.nullOutputStream(), new ImageFiles.PngOptions(16, Map.of()));
    }

    @Benchmark
    public Scene sceneFromJson() {
        return SceneReader.read(file);
    }
}
