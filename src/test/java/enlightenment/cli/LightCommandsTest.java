package enlightenment.cli;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.cli.option.DecimalNumber;
import enlightenment.color.Color;
import enlightenment.color.DisplayCurve;
import enlightenment.image.Image;
import enlightenment.image.ImageFiles;
import enlightenment.picture.Exposure;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.Method;
import enlightenment.scene.Shading;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** What the command line does with pictures of linear light. */
class LightCommandsTest {
    private static final Path CORNELL = Path.of("src/test/resources/physical/cornell.json");

    @TempDir
    Path folder;

    private Path map;
    private Path png;

    @BeforeEach
    void names() {
        map = folder.resolve("out.pfm");
        png = folder.resolve("out.png");
    }

    private static CliRun render(Path out, Object... more) {
        Object[] args = new Object[8 + more.length];
        Object[] first = {"render", CORNELL, "-o", out, "--size", "16x16", "--samples", "8"};
        System.arraycopy(first, 0, args, 0, first.length);
        System.arraycopy(more, 0, args, first.length, more.length);
        return CliRun.of(args);
    }

    private static Image shown(Path png) throws IOException {
        return ImageFiles.read(png);
    }

    private static Image asPng(Image light, DisplayCurve curve, Path file) throws IOException {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        ImageFiles.toPng(light.withCurve(curve), out, ImageFiles.PngOptions.DEFAULT);
        Files.write(file, out.toByteArray());
        return ImageFiles.read(file);
    }

    @Test
    void aFloatMapHoldsTheLightThatThePngFileShows() throws IOException {
        assertEquals(0, render(map).code());
        assertEquals(0, render(png).code());
        Image light = ImageFiles.read(map, Color.Encoding.LINEAR);
        assertArrayEquals(
                asPng(light, DisplayCurve.SRGB, folder.resolve("again.png")).toArray(),
                shown(png).toArray());
    }

    @Test
    void directAndIndirectLightAreShownAsThePictureIs() throws IOException {
        CliRun run = render(png, "--aov", "albedo,direct,indirect", "--exposure", "1");
        assertEquals(new CliRun(0, "", ""), run);
        assertEquals(0, render(map, "--aov", "direct,indirect").code());
        Image direct = ImageFiles.read(folder.resolve("out.direct.pfm"), Color.Encoding.LINEAR);
        assertArrayEquals(
                asPng(direct, DisplayCurve.of(1, DisplayCurve.Tone.CLIP), folder.resolve("a.png"))
                        .toArray(),
                shown(folder.resolve("out.direct.png")).toArray());
        float[] light = ImageFiles.read(map, Color.Encoding.LINEAR).toArray();
        float[] rest = ImageFiles.read(folder.resolve("out.indirect.pfm"), Color.Encoding.LINEAR)
                .toArray();
        for (int i = 0; i < light.length; i++) {
            assertEquals(light[i], direct.toArray()[i] + rest[i], 1e-6f * (1 + light[i]));
        }
        assertTrue(Files.exists(folder.resolve("out.albedo.png")));
    }

    @Test
    void inspectSaysWhatHasNoEffect() {
        String out = CliRun.of("inspect", "scenes/lamp-room.json").out();
        assertTrue(out.contains("shadowSamples=10: of classic shading"), out);
        assertTrue(out.contains("mirrors") && out.contains("indirect light"), out);
    }

    @Test
    void inspectSaysHowCausticsAreFound() {
        String images = "sampling of the images of lights in mirror balls";
        List<String> both = modelled(Path.of("scenes/fire-and-ice-physical.json"));
        assertTrue(both.contains("caustics by light tracing"), both.toString());
        assertTrue(both.contains(images + " (caustics seen in mirrors and through glass)"), both.toString());
        List<String> oneOfThem = modelled(Path.of("scenes/caustics.json"));
        assertTrue(oneOfThem.contains("caustics by light tracing"), oneOfThem.toString());
        assertFalse(oneOfThem.toString().contains(images), oneOfThem.toString());
        assertFalse(modelled(CORNELL).toString().contains("caustics"));
        String out = CliRun.of("inspect", CORNELL).out();
        assertTrue(out.contains("caustics by light tracing") && out.contains(images), out);
    }

    /** Trials of light paths end where the time is over. */
    @ParameterizedTest
    @MethodSource("methodsOfLight")
    void howeverShortTheTimeThereIsAPicture(Method method) {
        CliRun run = CliRun.of(
                "render",
                "scenes/caustics.json",
                "-o",
                png,
                "--size",
                "12x8",
                "--method",
                method,
                "--time",
                "0.000001",
                "--progress",
                "none");
        assertEquals(0, run.code(), run.err());
        assertTrue(run.err().contains("is too short"), run.err());
    }

    static List<BuiltInMethod> methodsOfLight() {
        return BuiltInMethod.rendering(Shading.Model.PHYSICAL);
    }

    @Test
    void inspectSaysWhichMethodsSeeWhat() {
        String mirror = CliRun.of("inspect", "scenes/caustics.json").out();
        assertTrue(mirror.contains("can render it:    raytrace, cluster"), mirror);
        assertTrue(mirror.contains("\n                  light cannot see surfaces in mirrors"), mirror);
        String classic = CliRun.of("inspect", "scenes/cube.json").out();
        assertTrue(classic.contains("can render it:    raytrace, cluster"), classic);
        assertFalse(classic.contains("light cannot see"), classic);
    }

    /** What inspect says is modelled of a scene. */
    private static List<String> modelled(Path scene) {
        String out = CliRun.of("inspect", scene).out();
        return out.substring(out.indexOf("modelled:") + "modelled:".length(), out.indexOf("not needed:"))
                .lines()
                .map(String::strip)
                .toList();
    }

    @Test
    void lightSamplesAreNothingToSweep() {
        CliRun run = CliRun.of("trade", CORNELL, "-o", folder.resolve("t"), "--sweep", "shadowSamples=1..4");
        assertEquals(2, run.code());
        assertTrue(run.err().contains("--sweep shadowSamples has nothing to vary with physical shading"), run.err());
        assertFalse(Files.exists(folder.resolve("t")));
    }

    @Test
    void anExposureIsANumberOrAutomatic() {
        assertEquals(
                new CliRun(
                        2, "", "enlightenment: --exposure must be auto or a number in -1000..1000, not \"bright\"\n"),
                render(png, "--exposure", "bright"));
    }

    @Test
    void classicShadingDoesNotTellDirectLightApart() {
        assertEquals(
                new CliRun(
                        2,
                        "",
                        "enlightenment: --aov albedo,direct is for physical shading: classic shading does not tell it apart\n"),
                CliRun.of("render", "scenes/cube.json", "-o", png, "--size", "4x4", "--aov", "direct,depth,albedo"));
        assertFalse(Files.exists(png));
    }

    @Test
    void anExposureIsAViewAndAutomaticSaysWhichItWas() throws IOException {
        assertEquals(0, render(map).code());
        Image light = ImageFiles.read(map, Color.Encoding.LINEAR);
        assertEquals(0, render(png, "--exposure", "1.5").code());
        assertArrayEquals(
                asPng(light, DisplayCurve.of(1.5, DisplayCurve.Tone.CLIP), folder.resolve("a.png"))
                        .toArray(),
                shown(png).toArray());
        CliRun run = render(png, "--exposure", "auto");
        double stops = Exposure.automatic(light);
        assertTrue(run.err().contains("exposure: " + DecimalNumber.plain(stops)), run.err());
        assertArrayEquals(
                asPng(light, DisplayCurve.of(stops, DisplayCurve.Tone.CLIP), folder.resolve("b.png"))
                        .toArray(),
                shown(png).toArray());
        assertEquals(2, render(map, "--exposure", "1").code());
        assertEquals(2, render(png, "--exposure", "bright").code());
    }

    @Test
    void classicPicturesHaveNoExposure() {
        CliRun run = CliRun.of("render", "scenes/cube.json", "-o", png, "--size", "8x8", "--exposure", "1");
        assertEquals(2, run.code());
        assertTrue(run.err().contains("classic shading"), run.err());
        assertFalse(Files.exists(png));
    }

    @Test
    void aDarkPictureGetsAHintUnlessItIsExposed() throws IOException {
        Path dark = folder.resolve("dark.json");
        Files.writeString(dark, Files.readString(CORNELL).replace("[17, 12, 4]", "[0.01, 0.01, 0.01]"));
        Object[] args = {"render", dark, "-o", png, "--size", "16x16", "--samples", "8", "--exposure", "auto"};
        assertFalse(CliRun.of(args).err().contains("hint"));
        Object[] plain = java.util.Arrays.copyOf(args, 8);
        assertTrue(CliRun.of(plain).err().contains("hint: the picture is nearly black"));
    }

    /** Light in another unit, a power of two, and the exposure that makes up for it. */
    private Path dim(int stops, int exposure) throws IOException {
        String text = Files.readString(CORNELL)
                .replace(
                        "[17, 12, 4]",
                        "[" + 17 * Math.scalb(1.0, -stops) + ", " + 12 * Math.scalb(1.0, -stops) + ", "
                                + 4 * Math.scalb(1.0, -stops) + "]");
        return Files.writeString(
                folder.resolve("dim.json"),
                text.substring(0, text.lastIndexOf('}')) + ", \"display\": { \"exposure\": " + exposure + " } }");
    }

    private CliRun shown(Path scene, String method) {
        return CliRun.of(
                "render",
                scene,
                "-o",
                png,
                "--size",
                "16x16",
                "--samples",
                8,
                "--method",
                method,
                "--progress",
                "none");
    }

    @ParameterizedTest
    @ValueSource(strings = {"raytrace", "cluster", "light", "bidirectional", "metropolis"})
    void lightBelowTheRangeOfFloatsIsToldWhereTheExposureShowsIt(String method) throws IOException {
        for (int stops : new int[] {150, 160, 250}) {
            CliRun run = shown(dim(stops, stops), method);
            assertEquals(1, run.code(), run.err());
            assertTrue(run.err().contains("numbers of the picture are below the range of floats"), run.err());
            assertFalse(run.err().contains("hint"), run.err());
            assertTrue(
                    run.err().contains("2^" + stops + " times as much, and the exposure " + stops + " less"),
                    run.err());
            run = shown(dim(stops, 0), method);
            assertEquals(0, run.code(), run.err());
            assertFalse(run.err().contains("--exposure"), run.err());
            assertFalse(run.err().contains("no light was found"), run.err());
        }
    }

    @Test
    void withinTheRangeOfFloatsTheUnitOfLightDoesNotMatter() throws IOException {
        List<byte[]> pictures = new ArrayList<>();
        for (int stops : new int[] {0, 100}) {
            assertEquals(0, shown(dim(stops, stops), "raytrace").code());
            pictures.add(Files.readAllBytes(png));
        }
        assertArrayEquals(pictures.get(0), pictures.get(1));
    }

    @Test
    void theReportHasTheErrorOfLight() throws IOException {
        Path report = folder.resolve("report.json");
        CliRun run = render(png, "--report", report, "--stats");
        assertTrue(run.out().contains("of linear light"), run.out());
        String json = Files.readString(report);
        for (String key : new String[] {"relativeError", "kurtosis", "heavyTail", "lostSamples"}) {
            assertTrue(json.contains("\"" + key + "\""), json);
        }
    }

    @Test
    void theReportSaysWhyTheProgramChoseAMethod() throws IOException {
        Path report = folder.resolve("report.json");
        CliRun run = render(png, "--report", report, "--method", "auto");
        assertEquals(0, run.code(), run.err());
        JsonNode told = JsonMapper.shared().readTree(Files.readString(report));
        String reason = told.get("methodReason").asString();
        assertTrue(run.err().contains(reason), run.err());
        assertFalse(told.get("settings").get("method").asString().equals("auto"));
        assertEquals(0, render(png, "--report", report, "--method", "raytrace").code());
        assertFalse(Files.readString(report).contains("methodReason"));
    }

    /** Two polished balls under a small lamp: whatever the samples show, and in pictures that are merged as well. */
    @Test
    void theLastLineSaysThatTheErrorMayBeUnderestimatedWhereAScenesLightIsUndersampled() throws IOException {
        Path scene = folder.resolve("polished.json");
        String ball = "{ \"type\": \"sphere\", \"center\": [%s, 0, 0], \"radius\": 0.5,"
                + " \"material\": { \"type\": \"glossy\", \"color\": \"#e0c0a0\", \"roughness\": 0.15 } }";
        Files.writeString(
                scene,
                """
                {
                  "image": { "width": 8, "height": 8 },
                  "camera": { "type": "perspective", "eye": [0, 1, -5], "lookAt": [0, 0, 0], "fieldOfView": 40 },
                  "shading": { "model": "physical", "background": { "linear": [0.2, 0.2, 0.2] } },
                  "lights": [ { "type": "sphere", "center": [2, 3, -2], "radius": 0.05, "color": "#ffffff", "power": 90 } ],
                  "objects": [ %s, %s ]
                }
                """
                        .formatted(ball.formatted("-0.6"), ball.formatted("0.6")));
        Path report = folder.resolve("report.json");
        Path part = folder.resolve("1.film");
        CliRun whole = CliRun.of("render", scene, "-o", png, "--samples", "8", "--report", report);
        CliRun.of("render", scene, "-o", part, "--samples", "8", "--part", "1/1");
        for (CliRun run : List.of(whole, CliRun.of("merge", part, "-o", map))) {
            assertEquals(0, run.code(), run.err());
            String[] lines = run.err().strip().split("\n");
            assertTrue(
                    lines[lines.length - 1].contains("warning: the error may be underestimated: few paths"), run.err());
        }
        assertTrue(Files.readString(report).contains("\"undersampled\""));
    }

    @Test
    void partsMakeThePictureOfOneMachineAndAreShownAsIsAskedFor() throws IOException {
        assertEquals(0, render(png, "--exposure", "0.5").code());
        Path one = folder.resolve("1.film");
        Path two = folder.resolve("2.film");
        assertEquals(0, render(one, "--part", "1/2").code());
        assertEquals(0, render(two, "--part", "2/2").code());
        Path merged = folder.resolve("merged.png");
        assertEquals(
                0,
                CliRun.of("merge", one, two, "-o", merged, "--exposure", "0.5").code());
        assertArrayEquals(Files.readAllBytes(png), Files.readAllBytes(merged));
        assertEquals(2, render(one, "--part", "1/2", "--exposure", "1").code());
    }

    @Test
    void floatMapsOfLightAreComparedAsShownAndAsLight() throws IOException {
        Path a = folder.resolve("a.pfm");
        Path b = folder.resolve("b.pfm");
        ImageFiles.writePfm(new Image(1, 1, new float[] {0.5f, 2, 4}, Color.Encoding.LINEAR), a);
        ImageFiles.writePfm(new Image(1, 1, new float[] {0.5f, 1, 4}, Color.Encoding.LINEAR), b);
        CliRun run = CliRun.of("compare", "--linear", a, b);
        assertEquals(0, run.code(), run.err());
        // A screen shows both as white.
        assertTrue(run.out().contains("RMSE:                0\n"), run.out());
        assertTrue(run.out().contains("RMSE of light:       0.577350"), run.out());
        assertTrue(run.out().contains("1.00000 red, 2.00000 green, 1.00000 blue"), run.out());
        // Where one picture is black there is no ratio.
        ImageFiles.writePfm(new Image(1, 1, new float[] {0, 1, 0}, Color.Encoding.LINEAR), b);
        assertTrue(CliRun.of("compare", "--linear", a, b).out().contains("none red, 2.00000 green, none blue"));
        ImageFiles.writePfm(new Image(1, 1, new float[] {0.5f, 1, 4}, Color.Encoding.LINEAR), b);
        CliRun darker = CliRun.of("compare", "--linear", "--exposure", "-2", "--tone", "filmic", a, b);
        assertFalse(darker.out().contains("RMSE:                0\n"), darker.out());
        assertEquals(2, CliRun.of("compare", "--exposure", "1", a, b).code());
        assertTrue(CliRun.of("compare", "--linear", "--json", a, b).out().contains("\"light\""));
    }
}
