import enlightenment.image.Image;
import enlightenment.image.ImageFiles;
import enlightenment.importer.SceneImporter;
import enlightenment.render.RenderRequest;
import enlightenment.render.RenderResult;
import enlightenment.render.Renderer;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.SceneException;
import java.io.IOException;
import java.nio.file.Path;

/**
 * A small picture of a model: what a shop, an archive of CAD files or a file manager needs.
 *
 * <pre>
 * java -cp enlightenment-0.1.0.jar:jackson-core.jar src/examples/java/Thumbnail.java model.glb thumbnail.png 256
 * </pre>
 *
 * <p>GLB, glTF, PLY, OBJ, STL, scenes of Mitsuba and pbrt are read. A model without a camera and light is seen from three quarters, in a
 * studio.
 */
public final class Thumbnail {
    private Thumbnail() {}

    public static void main(String[] args) throws IOException {
        Path model = Path.of(args[0]);
        Path picture = Path.of(args[1]);
        int side = args.length > 2 ? Integer.parseInt(args[2]) : 256;
        try {
            ImageFiles.writePng(thumbnail(model, side), picture);
        } catch (SceneException e) {
            // Files of users are broken now and then. Every problem is a line with file and place.
            e.problems().forEach(System.err::println);
            System.exit(1);
        }
    }

    static Image thumbnail(Path model, int side) throws IOException {
        SceneImporter.Result imported = SceneImporter.read(model, SceneImporter.Options.DEFAULT);
        // What of the file has no counterpart here is said, and no reason to fail.
        imported.notes().forEach(System.err::println);

        RenderSettings settings = RenderSettings.of(imported.scene())
                .withSize(side, side)
                .withSamples(16)
                // A server makes many thumbnails at once, each on one thread.
                .withThreads(1);
        // 16 samples per pixel leave grain, which a filter removes that knows surfaces from noise.
        RenderResult result =
                Renderer.render(RenderRequest.of(imported.scene(), settings).withDenoised(true));
        return result.denoised().orElse(result.image());
    }
}
