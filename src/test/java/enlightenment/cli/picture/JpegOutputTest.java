package enlightenment.cli.picture;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.cli.CliRun;
import enlightenment.cli.SceneFixture;
import enlightenment.image.Image;
import enlightenment.image.ImageError;
import enlightenment.image.ImageFiles;
import enlightenment.image.ImageFormat;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Pictures as JPEG files. */
class JpegOutputTest extends SceneFixture {
    private static final int WIDTH = 24;
    private static final int HEIGHT = 16;

    JpegOutputTest() {
        super(WIDTH, HEIGHT);
    }

    @BeforeEach
    void nameAJpegFile() {
        picture = folder.resolve("p.jpg");
    }

    private void refused(String message, CliRun run) {
        assertEquals(new CliRun(2, "", "enlightenment: " + message + "\n"), run);
        assertFalse(Files.exists(picture));
    }

    @Test
    void aJpegFileHoldsNearlyThePictureOfThePngFile() throws IOException {
        assertEquals(new CliRun(0, "", ""), render());
        assertEquals(Optional.of(ImageFormat.JPEG), ImageFormat.ofContent(Files.readAllBytes(picture)));
        Path png = folder.resolve("p.png");
        assertEquals(new CliRun(0, "", ""), CliRun.of("render", scene, "-o", png));
        Image exact = ImageFiles.read(png);
        Image lossy = ImageFiles.read(picture);
        // The transform keeps squares, and no coefficient is rounded to steps of more than 12 of 255; blue is luma +
        // 1.772 chroma.
        assertTrue(ImageError.between(lossy, exact).rmse() < 6 / 255.0 * (1 + 1.772));
    }

    @Test
    void theBytesDoNotDependOnThreadsAndRuns() throws IOException {
        byte[] one = CliRun.picture(words("render", "--threads", "1"));
        assertArrayEquals(one, CliRun.picture(words("render", "--threads", "3")));
    }

    @Test
    void theTextsOfPngFilesAreNotInIt() throws IOException {
        String bytes = new String(CliRun.picture(words("render")), StandardCharsets.ISO_8859_1);
        assertFalse(bytes.contains("Enlightenment") || bytes.contains("method=") || bytes.contains("Two balls"));
    }

    @Test
    void eightBitsMayBeAskedForAndSixteenAreRefused() {
        refused(
                "--depth 16 must not be given for a .jpg file, which holds 8 bits per component; .png holds 16",
                render("--depth", "16"));
        assertEquals(0, render("--depth", "8").code());
    }

    @Test
    void anErrorOfTheFileIsRefused() {
        refused(
                "--error is the error of the file, and what JPEG loses is not measured: choose .png or .pfm",
                render("--error", "0.01"));
    }

    @Test
    void aPictureThatIsLargerThanTheEncodersLimitIsRefusedBeforeItIsRendered() {
        refused(
                "a picture of 65501x1 pixels is too large for JPEG, which has at most 65500 columns and rows here;"
                        + " .png has more",
                render("--crop", "0,0,65501,1", "--size", "65501x43668", "--samples", "1"));
    }

    @Test
    void partsAreMergedIntoAJpegFileOfTheSameBytes() throws IOException {
        byte[] whole = CliRun.picture(words("render"));
        Files.delete(picture);
        Path part = folder.resolve("1.film");
        assertEquals(0, CliRun.of("render", scene, "-o", part, "--part", "1/1").code());
        assertEquals(0, CliRun.of("merge", part, "-o", picture).code());
        assertArrayEquals(whole, Files.readAllBytes(picture));
    }

    @Test
    void anErrorThatPartsWereRenderedForIsRefusedWhenTheyAreMerged() {
        Path part = folder.resolve("1.film");
        CliRun run = CliRun.of("render", scene, "-o", part, "--part", "1/1", "--error", "0.1");
        assertEquals(0, run.code(), run.err());
        refused(
                "--error is the error of the file, and what JPEG loses is not measured: choose .png or .pfm",
                CliRun.of("merge", part, "-o", picture));
    }
}
