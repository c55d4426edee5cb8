package enlightenment.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** What somebody who tries the program for the first time gets wrong. */
class FirstUseTest {
    private static final String SIZE = "\"width\": 16, \"height\": 12";

    @TempDir
    Path folder;

    @ParameterizedTest
    @CsvSource({
        "--sampels, --samples",
        "--smaples=4, --samples",
        "--antialiasing, --antialias",
        "--anti-alias, --antialias",
        "--shadowsamples, --shadow-samples",
        "--tme, --time",
        "--outptu, --output",
        "--SIZE, --size",
        "--thread, --threads",
        "--reprot, --report"
    })
    void anOptionThatThereIsNotSuggestsTheNearest(String written, String meant) throws IOException {
        Path scene = CliRun.scene(folder, SIZE);
        CliRun run = CliRun.of("render", scene, "-o", folder.resolve("p.png"), written);
        assertEquals(2, run.code());
        assertEquals(
                "enlightenment: unknown option: '" + written + "'; did you mean \"" + meant + "\"?",
                run.errLines().get(0));
    }

    @Test
    void theValueOfAMisspelledOptionDoesNotHideIt() throws IOException {
        Path scene = CliRun.scene(folder, SIZE);
        CliRun run = CliRun.of("render", scene, "--sampels", "4", "-o", folder.resolve("p.png"));
        assertEquals(
                "enlightenment: unknown option: '--sampels'; did you mean \"--samples\"?",
                run.errLines().get(0));
        run = CliRun.of("render", scene, "--sampels", "4", "--tme=3", "-o", folder.resolve("p.png"));
        assertEquals(
                "enlightenment: unknown option: '--tme=3'; did you mean \"--time\"?",
                run.errLines().get(1));
    }

    @ParameterizedTest
    @CsvSource({
        "rendr, render",
        "Render, render",
        "vaildate, validate",
        "inspct, inspect",
        "mrege, merge",
        "wroker, worker"
    })
    void aCommandThatThereIsNotSuggestsTheNearest(String written, String meant) {
        String first = "enlightenment: unknown command \"" + written + "\"; did you mean \"" + meant + "\"?";
        assertEquals(first, CliRun.of(written).errLines().get(0));
        assertEquals(
                first, CliRun.of(written, "a.json", "-o", "b.png").errLines().get(0));
        assertEquals(first, CliRun.of("help", written).errLines().get(0));
    }

    @ParameterizedTest
    @ValueSource(strings = {"--foo", "--colour", "-x"})
    void whatIsNearNothingSuggestsNothing(String option) throws IOException {
        CliRun run = CliRun.of("render", CliRun.scene(folder, SIZE), "-o", folder.resolve("p.png"), option);
        assertEquals(
                "enlightenment: unknown option: '" + option + "'",
                run.errLines().get(0));
        assertEquals(
                "enlightenment: unknown command \"scene.json\"",
                CliRun.of("scene.json").errLines().get(0));
    }

    @Test
    void aHiddenOptionIsNotSuggested() throws IOException {
        CliRun run = CliRun.of("trade", CliRun.scene(folder, SIZE), "-o", folder.resolve("t"), "--sampels", "3");
        assertFalse(run.err().contains("\"--samples\""), run.err());
    }

    private Path edited(String from, String to) throws IOException {
        Path scene = CliRun.scene(folder, SIZE);
        String text = Files.readString(scene);
        assertTrue(text.contains(from));
        return Files.writeString(scene, text.replace(from, to));
    }

    private String rendered(Path scene, Object... more) {
        Object[] args = IntStream.range(0, 4 + more.length)
                .mapToObj(i -> i < 4
                        ? List.of("render", scene, "-o", folder.resolve("p.png"))
                                .get(i)
                        : more[i - 4])
                .toArray();
        CliRun run = CliRun.of(args);
        assertEquals(0, run.code(), run.err());
        return run.err();
    }

    @Test
    void aPictureOfOneColourComesWithAHint() throws IOException {
        Path inside = edited("\"eye\": [0, 0, -5]", "\"eye\": [0, 0, -0.5]");
        Files.writeString(
                inside, Files.readString(inside).replace("\"name\"", "\"shading\": { \"shadow\": 0 }, \"name\""));
        String hint = "/camera: is inside /objects/0, which is opaque and holds no light";
        assertEquals(
                "enlightenment: the picture is one colour, #808080\nenlightenment: hint: " + hint + "\n",
                rendered(inside));
        CliRun inspect = CliRun.of("inspect", inside);
        assertTrue(inspect.out().endsWith("\nhints:            " + hint + "\n"), inspect.out());
    }

    @Test
    void whoLooksAwaySeesNothing() throws IOException {
        Path away = edited("\"lookAt\": [0, 0, 0]", "\"lookAt\": [0, 9, -5.1]");
        assertEquals(
                "enlightenment: the picture is one colour, #000000: the camera sees none of the objects\n",
                rendered(away));
        // Where a part is wanted, it may be empty.
        assertEquals("", rendered(CliRun.scene(folder, SIZE), "--crop", "0,0,2,2"));
    }

    @Test
    void aSceneThatMakesSenseHasNoHints() throws IOException {
        Path scene = CliRun.scene(folder, SIZE);
        assertEquals("", rendered(scene));
        assertFalse(CliRun.of("inspect", scene).out().contains("hints"));
    }

    @Test
    void aSizeThatStretchesTheWindowSaysSo() throws IOException {
        Path window = edited(
                "\"type\": \"perspective\", \"eye\": [0, 0, -5], \"lookAt\": [0, 0, 0], \"up\": [0, 1, 0],",
                "\"type\": \"window\", \"eye\": [0, 0, -5], \"lowerLeft\": [-2, -1, -3], \"upperLeft\": [-2, 1, -3],"
                        + " \"upperRight\": [2, 1, -3], \"lowerRight\": [2, -1, -3]");
        Files.writeString(window, Files.readString(window).replaceFirst("\\s*\"fieldOfView\": 40", ""));
        String stretched = "the camera's window is 2 times as wide as high, the picture of 32x32 pixels 1 times:"
                + " it is stretched; 32x16 is not";
        assertEquals("enlightenment: " + stretched + "\n", rendered(window, "--size", "32x32"));
        assertTrue(CliRun.of("inspect", window, "--size", "32x32").out().contains("hints:            " + stretched));
        // Half a pixel is not to be had.
        for (String fitting : List.of("32x16", "33x16", "33x17", "1x1", "800x400", "801x400")) {
            CliRun inspect = CliRun.of("inspect", window, "--size", fitting);
            assertEquals(new CliRun(0, inspect.out(), ""), inspect);
            assertFalse(inspect.out().contains("stretched"), fitting);
        }
        assertEquals("", rendered(window, "--size", "33x17"));
        assertTrue(rendered(window, "--size", "16x32").contains("0.5 times: it is stretched; 16x8 is not"));
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "\"type\": \"perspective\", \"eye\": [0, 0, -5], \"lookAt\": [0, 0, 0], \"fieldOfView\": 40",
                "\"type\": \"orthographic\", \"eye\": [0, 0, -5], \"lookAt\": [0, 0, 0], \"height\": 4",
                "\"type\": \"isometric\", \"lookAt\": [0, 0, 0], \"height\": 4"
            })
    void otherCamerasShowMoreOrLessInstead(String camera) throws IOException {
        Path scene = CliRun.scene(folder, SIZE);
        String text = Files.readString(scene);
        Files.writeString(scene, text.replaceFirst("(?s)\"camera\": \\{.*?}", "\"camera\": { " + camera + " }"));
        assertEquals("", rendered(scene, "--size", "32x8"));
        assertEquals("", rendered(scene, "--size", "8x32"));
    }
}
