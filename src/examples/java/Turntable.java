import enlightenment.image.ImageFiles;
import enlightenment.importer.SceneImporter;
import enlightenment.render.Film;
import enlightenment.render.RenderRequest;
import enlightenment.render.RenderResult;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;

/**
 * A product that turns once: frames for a page of a shop, which a script shows while the mouse is dragged.
 *
 * <pre>
 * java -cp enlightenment-0.1.0.jar:jackson-core.jar src/examples/java/Turntable.java model.glb frames 24 400
 * </pre>
 *
 * <p>Writes {@code frames/000.png} and so on. Frames do not depend on each other: each could be made by another machine.
 */
public final class Turntable {
    /** The eye is so far above the horizon, in degrees. */
    private static final double ELEVATION = 18;

    private static final double FRAMES_PER_SECOND = 12;

    private Turntable() {}

    public static void main(String[] args) throws IOException {
        Path model = Path.of(args[0]);
        Path folder = Files.createDirectories(Path.of(args[1]));
        int frames = args.length > 2 ? Integer.parseInt(args[2]) : 24;
        int side = args.length > 3 ? Integer.parseInt(args[3]) : 400;

        // A film is asked for a scene when its frame is due, so that one of them is in memory at a time.
        Film film = Film.of(frames, FRAMES_PER_SECOND, n -> seenFrom(model, 360.0 * n / frames));
        for (int n = 0; n < film.frames(); n++) {
            RenderRequest asked = film.request(n);
            RenderSettings settings = asked.settings().withSize(side, side).withSamples(16);
            RenderResult result = film.render(asked.withSettings(settings).withDenoised(true));
            Path file = folder.resolve(String.format("%03d.png", n));
            ImageFiles.writePng(result.denoised().orElse(result.image()), file);
            System.out.println(file);
        }
    }

    /** The model from a point on a circle around it; its studio stays where it is. */
    private static Scene seenFrom(Path model, double azimuth) {
        SceneImporter.Options options =
                SceneImporter.Options.DEFAULT.withOrbit(new SceneImporter.Options.Orbit(azimuth, ELEVATION));
        try {
            return SceneImporter.read(model, options).scene();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
