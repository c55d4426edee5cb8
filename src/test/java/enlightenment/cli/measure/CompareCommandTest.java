package enlightenment.cli.measure;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.cli.CliRun;
import enlightenment.cli.terminal.Version;
import enlightenment.image.Image;
import enlightenment.image.ImageFiles;
import enlightenment.image.flip.Flip;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Locale;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class CompareCommandTest {
    @TempDir
    Path folder;

    private Path a;
    private Path b;

    /** Both grey; one component of A is 0.25 more. RMSE 0.25/√(3·40·10) = 0.0072169. */
    @BeforeEach
    void writePictures() throws IOException {
        float[] rgb = new float[3 * 40 * 10];
        Arrays.fill(rgb, 0.5f);
        b = folder.resolve("b.pfm");
        ImageFiles.writePfm(new Image(40, 10, rgb.clone()), b);
        rgb[3 * (4 * 40 + 31) + 1] = 0.75f;
        a = folder.resolve("a.pfm");
        ImageFiles.writePfm(new Image(40, 10, rgb), a);
    }

    @Test
    void theTableHasAllFigures() throws IOException {
        CliRun run = CliRun.of("compare", a, b);
        assertEquals(0, run.code());
        assertEquals("", run.err());
        Flip flip = Flip.between(ImageFiles.read(a), ImageFiles.read(b));
        String expected =
                """
                size:                40x10
                RMSE:                0.007217
                relative MSE:        2.0032e-04
                mean absolute error: 2.0833e-04
                PSNR:                42.83 dB
                FLIP:                %.6f (largest %.6f, 67.02 pixels per degree)
                largest difference:  0.250000 at column 31, row 4, green
                """;
        assertEquals(String.format(Locale.ROOT, expected, flip.mean(), flip.largest()), run.out());
    }

    @Test
    void equalPicturesAreSaidToBeEqual() {
        String expected =
                """
                size:                40x10
                RMSE:                0
                relative MSE:        0
                mean absolute error: 0
                PSNR:                infinite
                FLIP:                0 (largest 0, 67.02 pixels per degree)
                largest difference:  0: the pictures are equal
                """;
        assertEquals(new CliRun(0, expected, ""), CliRun.of("compare", a, a, "--max-rmse", "0"));
    }

    @Test
    void jsonHasTheSameFiguresWithAllDigits() throws IOException {
        CliRun run = CliRun.of("compare", a, b, "--json", "--max-rmse", "0.01", "--pixels-per-degree", "30");
        Flip flip = Flip.between(ImageFiles.read(a), ImageFiles.read(b), 30);
        String expected =
                """
                {
                  "enlightenment": "VERSION",
                  "test": "A",
                  "reference": "B",
                  "width": 40,
                  "height": 10,
                  "rmse": RMSE,
                  "relativeMse": RELATIVE,
                  "meanAbsoluteError": 2.0833333333333335E-4,
                  "psnr": PSNR,
                  "flip": {
                    "mean": MEAN,
                    "largest": LARGEST,
                    "pixelsPerDegree": 30.0
                  },
                  "largestDifference": {
                    "value": 0.25,
                    "column": 31,
                    "row": 4,
                    "channel": "green"
                  },
                  "maxRmse": 0.01,
                  "passed": true
                }
                """
                        .replace("VERSION", Version.number())
                        .replace("\"A\"", "\"" + a + "\"")
                        .replace("\"B\"", "\"" + b + "\"")
                        .replace("RMSE", "" + Math.sqrt(0.0625 / 1200))
                        .replace("RELATIVE", "" + 0.0625 / (0.25 + 0.01) / 1200)
                        .replace("PSNR", "" + -10 * StrictMath.log10(0.0625 / 1200))
                        .replace("MEAN", "" + flip.mean())
                        .replace("LARGEST", "" + (double) flip.largest());
        assertEquals(new CliRun(0, expected, ""), run);
    }

    @Test
    void infinityIsNullInJson() {
        CliRun run = CliRun.of("compare", a, a, "--json");
        assertTrue(run.out().contains("\"psnr\": null,"), run.out());
        assertFalse(run.out().contains("passed"));
    }

    @Test
    void tooLargeAnErrorEndsWithOneAndStillTells() {
        CliRun run = CliRun.of("compare", a, b, "--max-rmse", "0.007");
        assertEquals(1, run.code());
        assertEquals(7, run.outLines().size());
        assertEquals(
                "enlightenment: the RMSE is " + Math.sqrt(0.0625 / 1200) + ", larger than --max-rmse 0.007\n",
                run.err());
        CliRun json = CliRun.of("compare", a, b, "--max-rmse", "0.007", "--json");
        assertEquals(1, json.code());
        assertTrue(json.out().endsWith("\"passed\": false\n}\n"), json.out());
    }

    @Test
    void pngAndPfmCanBeMixed() throws IOException {
        Path png = folder.resolve("b.png");
        ImageFiles.writePng(ImageFiles.read(b), png);
        // 0.5 becomes 128/255.
        CliRun run = CliRun.of("compare", png, b);
        assertTrue(run.out().contains("RMSE:                0.001961\n"), run.out());
        assertEquals(0, run.code());
    }

    @Test
    void theHeatMapShowsWhere() throws IOException {
        Path map = folder.resolve("map.png");
        assertEquals(0, CliRun.of("compare", a, b, "--heatmap", map).code());
        Image image = ImageFiles.read(map);
        assertEquals(40, image.width());
        assertEquals(25, image.height());
        // Dark where nothing differs, lightest at the pixel that does.
        assertEquals(0, image.component(2, 4, 0));
        for (int x = 0; x < 40; x++) {
            assertTrue(image.component(x, 4, 0) <= image.component(31, 4, 0));
        }
        assertTrue(image.component(31, 4, 0) > 0.1);
        byte[] first = Files.readAllBytes(map);
        CliRun.of("compare", a, b, "--heatmap", map);
        assertArrayEquals(first, Files.readAllBytes(map));
    }

    @Test
    void sizesMustBeEqual() throws IOException {
        Path other = folder.resolve("other.png");
        ImageFiles.writePng(new Image(10, 40, new float[1200]), other);
        wrong(
                "the pictures differ in size: " + a + " has 40x10 pixels, " + other + " has 10x40",
                "compare",
                a,
                other,
                "--max-rmse",
                "1");
    }

    @Test
    void whatIsNoNumberIsToldWithFileAndPlace() throws IOException {
        float[] rgb = new float[1200];
        rgb[3 * 41 + 2] = Float.NaN;
        Path bad = folder.resolve("bad.pfm");
        ImageFiles.writePfm(new Image(40, 10, rgb), bad);
        wrong(bad + ": there is NaN in column 1, row 1, blue", "compare", bad, b);
        wrong(bad + ": there is NaN in column 1, row 1, blue", "compare", a, bad);
    }

    @Test
    void picturesThatCannotBeReadAreWrongInput() throws IOException {
        Path missing = folder.resolve("missing.png");
        wrong("cannot read " + missing + ": there is no such file", "compare", missing, b);
        wrong("cannot read " + missing + ": there is no such file", "compare", a, missing);
        wrong("cannot read " + folder + ": it is a folder", "compare", folder, b);
        Path whole = folder.resolve("whole.png");
        ImageFiles.writePng(ImageFiles.read(a), whole);
        byte[] bytes = Files.readAllBytes(whole);
        Path half = Files.write(folder.resolve("half.png"), Arrays.copyOf(bytes, bytes.length / 2));
        wrong("cannot read " + half + ": it ends too early", "compare", half, b);
        Path empty = Files.write(folder.resolve("empty.png"), new byte[0]);
        wrong("cannot read " + empty + ": it is empty", "compare", empty, b);
        Path text = Files.writeString(folder.resolve("text.png"), "a picture");
        wrong("cannot read " + text + ": it is neither PNG, JPEG, BMP, PFM, HDR nor EXR", "compare", text, b);
    }

    @ParameterizedTest
    @ValueSource(strings = {"NaN", "-0.1", "Infinity", "1e400", "0.1f", "0x1p-3", "", "small"})
    void limitsAreNumbersOfAtLeastZero(String limit) {
        wrong(
                "--max-rmse must be a number of at least 0, not \"" + limit + "\"",
                "compare",
                a,
                b,
                "--max-rmse=" + limit);
    }

    @ParameterizedTest
    @ValueSource(strings = {"NaN", "0", "-67", "1000.5"})
    void pixelsPerDegreeHaveLimits(String density) {
        wrong(
                "--pixels-per-degree must be a number in 1..1000, not \"" + density + "\"",
                "compare",
                a,
                b,
                "--pixels-per-degree=" + density);
    }

    @ParameterizedTest
    @CsvSource({"map.jpg", "map.pfm", "map"})
    void heatMapsArePngFiles(String name) {
        Path map = folder.resolve(name);
        wrong("--heatmap must name a file that ends in .png, not \"" + map + "\"", "compare", a, b, "--heatmap", map);
    }

    @Test
    void theHeatMapReplacesNeitherPicture() throws IOException {
        Path png = folder.resolve("a.png");
        ImageFiles.writePng(ImageFiles.read(a), png);
        byte[] before = Files.readAllBytes(png);
        String over = "--heatmap would write over ";
        wrong(over + "picture A, \"" + png + "\"", "compare", png, b, "--heatmap", png);
        wrong(over + "the reference B, \"" + png + "\"", "compare", b, png, "--heatmap", png);
        assertArrayEquals(before, Files.readAllBytes(png));
    }

    @Test
    void aHeatMapThatCannotBeWrittenIsAFailure() {
        Path map = folder.resolve("no/map.png");
        CliRun run = CliRun.of("compare", a, b, "--heatmap", map);
        assertEquals(1, run.code());
        assertEquals("", run.out());
        assertEquals(
                "enlightenment: " + map + ": cannot be written: there is no folder "
                        + map.toAbsolutePath().getParent() + "\n",
                run.err());
    }

    private static void wrong(String message, Object... args) {
        assertEquals(new CliRun(2, "", "enlightenment: " + message + "\n"), CliRun.of(args));
    }
}
