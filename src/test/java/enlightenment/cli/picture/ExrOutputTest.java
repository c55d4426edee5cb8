package enlightenment.cli.picture;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import enlightenment.cli.CliRun;
import enlightenment.cli.SceneFixture;
import enlightenment.codec.ParsedExr;
import enlightenment.image.Image;
import enlightenment.image.ImageFiles;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.zip.DataFormatException;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Pictures as OpenEXR files. */
class ExrOutputTest extends SceneFixture {
    private static final int WIDTH = 24;
    private static final int HEIGHT = 18;

    ExrOutputTest() {
        super(WIDTH, HEIGHT);
    }

    @BeforeEach
    void nameAnExrFile() {
        picture = folder.resolve("p.exr");
    }

    private void refused(String message, CliRun run) {
        assertEquals(new CliRun(2, "", "enlightenment: " + message + "\n"), run);
        assertFalse(Files.exists(picture));
    }

    private Image pfm(String... options) throws IOException {
        List<String> words = new ArrayList<>(List.of("render", scene.toString(), "-o", folder.resolve("p.pfm") + ""));
        words.addAll(List.of(options));
        assertEquals(new CliRun(0, "", ""), CliRun.of(words.toArray()));
        return ImageFiles.read(folder.resolve("p.pfm"));
    }

    @Test
    void theFileHoldsTheNumbersOfTheFloatMapBitByBit() throws IOException {
        assertEquals(new CliRun(0, "", ""), render());
        assertArrayEquals(pfm().toArray(), ImageFiles.read(picture).toArray());
    }

    @Test
    void theBytesDoNotDependOnThreadsRunsAndWhereTheyGo() throws IOException {
        byte[] one = CliRun.picture(words("render", "--threads", "1"));
        assertArrayEquals(one, CliRun.picture(words("render", "--threads", "3")));
        assertEquals(new CliRun(0, "", ""), render());
        assertArrayEquals(one, Files.readAllBytes(picture));
    }

    @Test
    void halvesAreWithinAUnitInTheLastPlaceOfTheFloats() throws IOException, DataFormatException {
        assertEquals(new CliRun(0, "", ""), render("--depth", "16"));
        ParsedExr exr = new ParsedExr(Files.readAllBytes(picture));
        assertEquals(List.of(1, 1, 1), new ArrayList<>(exr.kinds.values()));
        float[] halves = ImageFiles.read(picture).toArray();
        float[] floats = pfm().toArray();
        for (int i = 0; i < floats.length; i++) {
            assertEquals(floats[i], halves[i], Math.max(floats[i] / 2048, 0x1p-25f));
        }
    }

    @Test
    void aCropLiesInTheWindowOfTheWholePicture() throws IOException, DataFormatException {
        assertEquals(new CliRun(0, "", ""), render("--crop", "3,5,7,11"));
        ParsedExr exr = new ParsedExr(Files.readAllBytes(picture));
        assertEquals(List.of(3, 5, 9, 15), exr.integers("dataWindow"));
        assertEquals(List.of(0, 0, WIDTH - 1, HEIGHT - 1), exr.integers("displayWindow"));
        assertArrayEquals(
                pfm("--crop", "3,5,7,11").toArray(), ImageFiles.read(picture).toArray());
    }

    @Test
    void furtherNumbersAreChannelsOfTheOneFile() throws IOException, DataFormatException {
        String kinds = "error,samples,depth,normal,position,object";
        assertEquals(new CliRun(0, "", ""), render("--aov", kinds, "--depth", "16"));
        ParsedExr exr = new ParsedExr(Files.readAllBytes(picture));
        pfm("--aov", kinds);
        int channels = 3;
        for (String kind : kinds.split(",")) {
            float[] raw = ImageFiles.read(folder.resolve("p." + kind + ".pfm")).toArray();
            String names = kind.equals("depth") ? "Z" : kind.equals("normal") || kind.equals("position") ? "XYZ" : "Y";
            for (int c = 0; c < names.length(); c++) {
                float[] channel = exr.floats(kind + "." + names.charAt(c));
                for (int i = 0; i < channel.length; i++) {
                    assertEquals(raw[3 * i + c], channel[i]);
                }
                channels++;
            }
            assertFalse(Files.exists(folder.resolve("p." + kind + ".exr")));
        }
        assertEquals(channels, exr.kinds.size());
        assertEquals(List.of(1, 1, 1), new ArrayList<>(exr.kinds.values()).subList(0, 3));
    }

    @Test
    void theFileSaysOfItselfWhatAPngFileDoes() throws IOException, DataFormatException {
        assertEquals(new CliRun(0, "", ""), render());
        ParsedExr exr = new ParsedExr(Files.readAllBytes(picture));
        String settings = exr.string("Settings");
        assertEquals("method=raytrace size=" + WIDTH + "x" + HEIGHT, settings.substring(0, settings.indexOf(" antia")));
        assertEquals("string", exr.types.get("Software"));
    }

    @Test
    void partsAreMergedIntoAFileOfTheSameBytes() throws IOException {
        byte[] whole = CliRun.picture(words("render", "--crop", "3,5,7,11"));
        Files.delete(picture);
        Path part = folder.resolve("1.film");
        CliRun run = CliRun.of("render", scene, "-o", part, "--part", "1/1", "--crop", "3,5,7,11");
        assertEquals(0, run.code(), run.err());
        assertEquals(0, CliRun.of("merge", part, "-o", picture).code());
        assertArrayEquals(whole, Files.readAllBytes(picture));
    }

    @Test
    void depthsOfOtherFormatsAreRefused() {
        refused(
                "--depth 8 must not be given for a .exr file, which holds 32 or 16 bits per component; .png holds 8",
                render("--depth", "8"));
        refused(
                "--depth 32 must not be given for a .png file, which holds 8 or 16 bits per component; .exr holds 32",
                CliRun.of("render", scene, "-o", folder.resolve("p.png"), "--depth", "32"));
    }

    @Test
    void anErrorOfHalvesIsRefusedAndOneOfFloatsIsKept() {
        refused(
                "--error is the error of the file, and what floats of 16 bits lose is not measured: leave out --depth 16",
                render("--error", "0.1", "--depth", "16"));
        assertEquals(0, render("--error", "0.1").code());
        Path part = folder.resolve("1.film");
        CliRun run = CliRun.of("render", scene, "-o", part, "--part", "1/1", "--error", "0.1", "--depth", "32");
        assertEquals(0, run.code(), run.err());
        assertEquals(0, CliRun.of("merge", part, "-o", picture).code());
    }
}
