package enlightenment.cli.picture;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.cli.CliRun;
import enlightenment.image.ImageFiles;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The second picture of a render, without grain. */
class DenoisedOutputTest {
    private static final Path SCENE = Path.of("scenes/cornell-box.json");

    @TempDir
    private Path folder;

    private Path picture;
    private Path denoised;

    @BeforeEach
    void nameFiles() {
        picture = folder.resolve("p.pfm");
        denoised = folder.resolve("d.pfm");
    }

    private CliRun render(Object... options) {
        List<Object> words =
                new ArrayList<>(List.of("render", SCENE, "-o", picture, "--size", "24x20", "--samples", 16));
        words.addAll(Arrays.asList(options));
        return CliRun.of(words.toArray());
    }

    private static double roughness(Path file) throws IOException {
        float[] rgb = ImageFiles.read(file).toArray();
        double sum = 0;
        for (int k = 3; k < rgb.length; k++) {
            sum += Math.abs(rgb[k] - rgb[k - 3]);
        }
        return sum;
    }

    @Test
    void theSecondPictureIsSmootherAndTheFirstUnchanged() throws IOException {
        assertEquals(0, render().code());
        byte[] alone = Files.readAllBytes(picture);
        assertEquals(0, render("--denoised", denoised).code());
        assertArrayEquals(alone, Files.readAllBytes(picture));
        assertTrue(roughness(denoised) < roughness(picture), roughness(denoised) + " of " + roughness(picture));
    }

    @ParameterizedTest
    @ValueSource(strings = {"raytrace", "cluster", "metropolis", "bidirectional"})
    void theBytesDoNotDependOnThreads(String method) throws IOException {
        assertEquals(
                0,
                render("--denoised", denoised, "--method", method, "--threads", 1)
                        .code());
        byte[] one = Files.readAllBytes(denoised);
        assertEquals(
                0,
                render("--denoised", denoised, "--method", method, "--threads", 3)
                        .code());
        assertArrayEquals(one, Files.readAllBytes(denoised));
    }

    @ParameterizedTest
    @ValueSource(strings = {"png", "exr"})
    void theFileSaysWhatItIs(String extension) throws IOException {
        denoised = folder.resolve("d." + extension);
        picture = folder.resolve("p." + extension);
        assertEquals(0, render("--denoised", denoised).code());
        assertTrue(text(denoised).contains("denoised\0"));
        assertTrue(text(denoised).contains("its error is not known"));
        assertFalse(text(picture).contains("denoised"));
    }

    private static String text(Path file) throws IOException {
        return new String(Files.readAllBytes(file), StandardCharsets.ISO_8859_1);
    }

    @Test
    void cropsAreFilteredAlone() throws IOException {
        assertEquals(0, render("--denoised", denoised, "--crop", "3,4,5,6").code());
        assertEquals(5, ImageFiles.read(denoised).width());
        assertEquals(6, ImageFiles.read(denoised).height());
    }

    @Test
    void bothFilesMustDiffer() {
        assertRefused("-o and --denoised would write the same file", "--denoised", picture);
        assertRefused(
                "--aov depth and --denoised would write the same file",
                "--aov",
                "depth",
                "--denoised",
                folder.resolve("p.depth.pfm"));
    }

    @Test
    void whatCannotBeWrittenIsRefused() {
        assertRefused("--denoised must name a file that ends in", "--denoised", folder.resolve("d.txt"));
        assertRefused("\"-\"", "--denoised", "-");
        picture = folder.resolve("p.film");
        assertRefused("there is no picture yet", "--denoised", denoised, "--part", "1/2");
    }

    private void assertRefused(String message, Object... options) {
        CliRun run = render(options);
        assertEquals(2, run.code(), run.err());
        assertTrue(run.err().contains(message), run.err());
        assertFalse(Files.exists(picture));
    }

    @Test
    void classicShadingIsRefused() {
        CliRun run = CliRun.of("render", "scenes/fire-and-ice.json", "-o", picture, "--denoised", denoised);
        assertEquals(2, run.code());
        assertTrue(run.err().contains("--denoised is for physical shading"), run.err());
    }
}
