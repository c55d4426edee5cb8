package enlightenment.cli;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.image.Image;
import enlightenment.image.ImageFiles;
import enlightenment.toy.AmbientOcclusion;
import enlightenment.toy.EyeVisibility;
import enlightenment.toy.HalfAndHalf;
import enlightenment.toy.ToyScene;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Methods that only the tests have, one of either kind and one of both, make the same bytes whatever way the command line takes with them.
 */
class ToyMethodsCommandTest {
    @TempDir
    Path folder;

    private Path scene;

    @BeforeEach
    void scene() throws IOException {
        scene = Files.writeString(
                folder.resolve("scene.json"), ToyScene.TEXT.replace("\"antialias\": 16", "\"antialias\": 4"));
    }

    private Path render(String name, Object... options) {
        Path file = folder.resolve(name);
        List<Object> args = new ArrayList<>(List.of("render", scene, "-o", file));
        args.addAll(List.of(options));
        CliRun run = CliRun.of(args.toArray());
        assertEquals(0, run.code(), run.err());
        return file;
    }

    @ParameterizedTest
    @ValueSource(strings = {AmbientOcclusion.WORD, EyeVisibility.WORD, HalfAndHalf.WORD})
    void threadsAndPartsMakeTheSameBytes(String method) throws IOException {
        byte[] whole = Files.readAllBytes(render("a.png", "--method", method, "--threads", 1));
        assertArrayEquals(whole, Files.readAllBytes(render("b.png", "--method", method, "--threads", 3)));
        Path a = render("a.film", "--method", method, "--part", "1/3");
        Path b = render("b.film", "--method", method, "--part", "2/3", "--threads", 2);
        Path c = render("c.film", "--method", method, "--part", "3/3");
        Path merged = folder.resolve("merged.png");
        CliRun run = CliRun.of("merge", b, c, a, "-o", merged);
        assertEquals(0, run.code(), run.err());
        assertArrayEquals(whole, Files.readAllBytes(merged));
    }

    @ParameterizedTest
    @ValueSource(strings = {AmbientOcclusion.WORD, EyeVisibility.WORD, HalfAndHalf.WORD})
    void aCropHasThePixelsOfTheWhole(String method) throws IOException {
        Image whole = ImageFiles.read(render("a.pfm", "--method", method));
        Image crop = ImageFiles.read(render("b.pfm", "--method", method, "--crop", "13,9,20,11"));
        for (int y = 0; y < crop.height(); y++) {
            for (int x = 0; x < crop.width(); x++) {
                for (int c = 0; c < 3; c++) {
                    assertEquals(whole.component(13 + x, 9 + y, c), crop.component(x, y, c));
                }
            }
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {AmbientOcclusion.WORD, EyeVisibility.WORD, HalfAndHalf.WORD})
    void manySamplesAreMadeInPassesOrBatchesAndTheErrorAskedForIsKept(String method) throws IOException {
        byte[] whole = Files.readAllBytes(render("a.png", "--method", method, "--samples", 300, "--threads", 1));
        assertArrayEquals(whole, Files.readAllBytes(render("b.png", "--method", method, "--samples", 300)));
        CliRun run = CliRun.of(
                "render", scene, "-o", folder.resolve("c.png"), "--method", method, "--error", "0.02", "--stats");
        assertEquals(0, run.code(), run.err());
        assertTrue(run.out().contains("estimated error"), run.out());
    }

    @ParameterizedTest
    @ValueSource(strings = {AmbientOcclusion.WORD, EyeVisibility.WORD, HalfAndHalf.WORD})
    void auxiliaryPicturesTellErrorAndSamples(String method) throws IOException {
        Path error = folder.resolve("a.error.pfm");
        Path samples = folder.resolve("a.samples.pfm");
        render("a.pfm", "--method", method, "--aov", "error,samples");
        assertTrue(Files.exists(error) && Files.exists(samples));
        float first = ImageFiles.read(samples).toArray()[0];
        assertTrue(first >= 1, "samples: " + first);
    }

    @ParameterizedTest
    @ValueSource(strings = {AmbientOcclusion.WORD, EyeVisibility.WORD, HalfAndHalf.WORD})
    void inspectAndTradeKnowThem(String method) {
        CliRun run = CliRun.of("inspect", scene, "--method", method);
        assertEquals(0, run.code(), run.err());
        assertTrue(run.out().contains(method + ": "), run.out());
    }
}
