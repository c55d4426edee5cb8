package enlightenment.cli.picture;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.cli.CliRun;
import enlightenment.color.Color;
import enlightenment.color.DisplayCurve;
import enlightenment.colorimetry.TransferCurve;
import enlightenment.image.Image;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

class BrightnessHintTest {
    private static final String AUTO = ": --exposure auto shows more of it";

    @TempDir
    Path folder;

    private static List<String> told(Image shown, boolean holdsFloats) {
        List<String> told = new ArrayList<>();
        BrightnessHint.tell(shown, holdsFloats, (kind, line) -> told.add(line));
        return told;
    }

    private static List<String> told(Image shown) {
        return told(shown, false);
    }

    /** A hundred grey pixels; from the given one on they are of the second grey. */
    private static Image grey(double first, double second, int change, DisplayCurve curve) {
        float[] rgb = new float[300];
        Arrays.fill(rgb, 0, 3 * change, (float) first);
        Arrays.fill(rgb, 3 * change, 300, (float) second);
        return new Image(10, 10, rgb, curve);
    }

    private static Image grey(double display, DisplayCurve curve) {
        double value = curve.encoding() == Color.Encoding.LINEAR ? TransferCurve.decode(display) : display;
        return grey(value, value, 50, curve);
    }

    @Test
    void fiveStepsFromBlackAndWhiteAreTheLimits() {
        for (DisplayCurve curve : List.of(DisplayCurve.SRGB, DisplayCurve.NONE)) {
            for (double display : new double[] {0.0202, 0.1, 0.5, 0.9798}) {
                assertEquals(List.of(), told(grey(display, curve)), display + " " + curve);
            }
            assertTrue(told(grey(0.0198, curve))
                    .get(0)
                    .startsWith("hint: the picture is nearly black, 0.0198 in the mean of its lit pixels: "));
            assertTrue(told(grey(0.9802, curve))
                    .get(0)
                    .startsWith("hint: the picture is nearly white, 0.9802 in the mean: "));
        }
    }

    @Test
    void theExposureIsNamedForLightAndSaidNotToBeOfClassicShading() {
        assertEquals(
                List.of("hint: the picture is nearly black, 0.0100 in the mean of its lit pixels" + AUTO),
                told(grey(0.01, DisplayCurve.SRGB)));
        assertEquals(
                List.of("hint: the picture is nearly white, 1.0000 in the mean" + AUTO),
                told(grey(1e6, 2e6, 50, DisplayCurve.SRGB)));
        String only = "; --exposure auto is for physical shading only";
        assertEquals(
                List.of(
                        "hint: the picture is nearly black, 0.0100 in the mean of its lit pixels: make lights and surfaces brighter"
                                + only),
                told(grey(0.01, DisplayCurve.NONE)));
        assertEquals(
                List.of("hint: the picture is nearly white, 0.9900 in the mean: make lights and surfaces darker"
                        + only),
                told(grey(0.99, DisplayCurve.NONE)));
    }

    /** One pixel of a hundred is lit: of all pixels the mean is below 0.01. */
    @Test
    void aBrightThingBeforeBlackIsAsItShouldBe() {
        for (double display : new double[] {0.0202, 0.2, 1}) {
            assertEquals(List.of(), told(grey(0, TransferCurve.decode(display), 99, DisplayCurve.SRGB)));
            assertEquals(List.of(), told(grey(0, display, 99, DisplayCurve.NONE)));
        }
        assertEquals(
                1,
                told(grey(0, TransferCurve.decode(0.0198), 99, DisplayCurve.SRGB))
                        .size());
        assertEquals(1, told(grey(0, 0.0198, 99, DisplayCurve.NONE)).size());
    }

    @Test
    void whatWasExposedAutomaticallyIsNotTold() {
        Image dark = grey(1e-6, 4e-6, 50, DisplayCurve.SRGB);
        assertEquals(1, told(dark).size());
        double stops = enlightenment.picture.Exposure.automatic(dark);
        assertEquals(List.of(), told(dark.withCurve(DisplayCurve.SRGB.withExposure(stops))));
    }

    @Test
    void anExposureIsRecommendedOnlyWhereItHelps() {
        assertEquals(
                List.of(
                        "hint: the picture is nearly black, 0.0000 in the mean of its lit pixels: its light is at the end of the range of"
                                + " floats; give the lights more"),
                told(grey(Float.MIN_VALUE, Float.MIN_VALUE, 50, DisplayCurve.SRGB)));
        assertEquals(
                List.of(),
                told(grey(Float.MIN_VALUE, Float.MIN_VALUE, 50, DisplayCurve.SRGB.withExposure(150))),
                "what is lost is told as a failure");
    }

    @Test
    void aPictureWithoutLightIsBlack() {
        for (DisplayCurve curve : List.of(DisplayCurve.SRGB, DisplayCurve.NONE)) {
            for (boolean holdsFloats : new boolean[] {false, true}) {
                assertEquals(
                        List.of("hint: the picture is black: no light was found"), told(grey(0, curve), holdsFloats));
            }
        }
    }

    @Test
    void floatsOfLightAreAsTheyAreWhateverTheExposure() {
        assertEquals(List.of(), told(grey(0.01, DisplayCurve.SRGB), true));
        assertEquals(List.of(), told(grey(1e6, 2e6, 50, DisplayCurve.SRGB), true));
        assertEquals(1, told(grey(0.01, DisplayCurve.NONE), true).size());
    }

    @Test
    void aPartAndASinglePixelMayBeDark() throws IOException {
        Path dark = Files.writeString(
                folder.resolve("dark.json"),
                Files.readString(Path.of("src/test/resources/physical/cornell.json"))
                        .replace("[17, 12, 4]", "[17e-6, 12e-6, 4e-6]"));
        for (String[] part : new String[][] {{"--size", "1x1"}, {"--size", "16x16", "--crop", "0,0,8,8"}}) {
            List<Object> words =
                    new ArrayList<>(List.of("render", dark, "-o", folder.resolve("p.png"), "--samples", "8"));
            words.addAll(List.of(part));
            CliRun run = CliRun.of(words.toArray());
            assertEquals(0, run.code(), run.err());
            assertFalse(run.err().contains("hint"), run.err());
        }
    }

    private static Stream<Path> shippedScenes() throws IOException {
        try (Stream<Path> files = Files.list(Path.of("scenes"))) {
            return files.filter(f -> f.toString().endsWith(".json")).sorted().toList().stream();
        }
    }

    @ParameterizedTest
    @MethodSource("shippedScenes")
    void shippedScenesAreNeitherNearlyBlackNorNearlyWhite(Path scene) {
        CliRun run = CliRun.of("render", scene, "-o", folder.resolve("p.png"), "--size", "16x8", "--samples", "2");
        assertEquals(0, run.code(), run.err());
        assertFalse(run.err().contains("the picture is"), run.err());
    }

    /** Light of a million times the power, and of a millionth. */
    @Test
    void aSceneWithLightInAnotherUnitIsToldOnceInOneLine() throws IOException {
        String text = Files.readString(Path.of("src/test/resources/physical/cornell.json"));
        for (String factor : List.of("e6", "e-6")) {
            Path scene = Files.writeString(
                    folder.resolve("scene.json"),
                    text.replace("[17, 12, 4]", "[17" + factor + ", 12" + factor + ", 4" + factor + "]"));
            Object[] words = {
                "render",
                scene,
                "-o",
                folder.resolve("p.png"),
                "--size",
                "16x16",
                "--samples",
                "8",
                "--exposure",
                "auto"
            };
            List<String> lines = CliRun.of(Arrays.copyOf(words, 8)).errLines();
            String what = factor.equals("e6") ? "white" : "black";
            assertEquals(
                    1, lines.stream().filter(l -> l.contains("nearly " + what)).count(), lines.toString());
            assertTrue(lines.stream().anyMatch(l -> l.endsWith(AUTO)), lines.toString());
            assertFalse(CliRun.of(words).err().contains("hint"));
        }
    }
}
