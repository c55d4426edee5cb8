package enlightenment.cli.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.cli.CliRun;
import enlightenment.cli.input.FrameChoice;
import enlightenment.color.Color;
import enlightenment.image.Image;
import enlightenment.image.ImageFiles;
import enlightenment.scene.Animation;
import java.io.IOException;
import java.math.BigDecimal;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.TreeMap;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** What is wrong with an animation shows in some of its frames only. */
class ValidateFramesTest {
    @TempDir
    Path folder;

    private Path animated(String animation) throws IOException {
        Path scene = CliRun.scene(folder, "\"width\": 16, \"height\": 12");
        String text = Files.readString(scene);
        int end = text.lastIndexOf('}');
        return Files.writeString(scene, text.substring(0, end) + ", \"animation\": " + animation + "}");
    }

    @Test
    void allFramesAreLookedAt() throws IOException {
        Path scene = animated(
                """
                { "frames": 11, "framesPerSecond": 25,
                  "tracks": [{ "target": "/objects/0/radius", "keys": { "0": 1, "10": 2 } }] }
                """);
        assertEquals(new CliRun(0, scene + ": valid in all 11 frames\n", ""), CliRun.of("validate", scene));
    }

    @Test
    void eachProblemIsToldInTheFirstFrameThatHasIt() throws IOException {
        // 1, 0.8, ..., 0 in frame 5, and so on to -1; the eye reaches what it looks at in frame 8.
        Path scene = animated(
                """
                { "frames": 11, "framesPerSecond": 25, "tracks": [
                  { "target": "/objects/0/radius", "keys": { "0": 1, "10": -1 } },
                  { "target": "/camera/eye/2", "keys": { "0": -8, "10": 2 } } ] }
                """);
        CliRun run = CliRun.of("validate", scene);
        assertEquals(2, run.code());
        assertEquals("", run.out());
        assertEquals(3, run.errLines().size(), run.err());
        assertTrue(run.errLines().get(0).contains("/objects/0/radius: must be a number greater than 0, not 0"));
        assertTrue(run.errLines().get(0).endsWith("(in frame 5)"), run.err());
        assertTrue(run.errLines().get(1).contains("/camera/lookAt: must differ from \"eye\" (in frame 8)"), run.err());
        assertEquals(
                scene + ": 6 of all 11 frames cannot be used: 5..10",
                run.errLines().get(2));
    }

    /** What physical light cannot be computed of is known before a frame is rendered, too. */
    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "/lights/0/radius | 1e-160 | /lights/0/power: is too much for a light of this size",
                "/lights/0/center/1 | 1e250 | /lights/0: is about 1e250 times as far from the eye"
            })
    void aFrameOfPhysicalLightIsAsStrictlyLookedAtAsItIsRendered(String target, String value, String problem)
            throws IOException {
        Path scene = Files.writeString(
                folder.resolve("lamp.json"),
                """
                { "image": { "width": 8, "height": 8 },
                  "camera": { "type": "perspective", "eye": [0, 0, -5], "lookAt": [0, 0, 0], "fieldOfView": 40 },
                  "shading": { "model": "physical" },
                  "materials": { "grey": { "type": "matte", "color": "#808080" } },
                  "lights": [{ "type": "sphere", "center": [0, 4, -4], "radius": 1, "color": "#ffffff", "power": 100 }],
                  "objects": [{ "type": "sphere", "center": [0, 0, 0], "radius": 1, "material": "grey" }],
                  "animation": { "frames": 4, "framesPerSecond": 25,
                    "tracks": [{ "target": "%s", "keys": { "0": 1, "2": 1, "3": %s } }] } }
                """
                        .formatted(target, value));
        CliRun run = CliRun.of("validate", scene);
        assertEquals(2, run.code());
        assertTrue(run.errLines().get(0).contains(problem), run.err());
        assertTrue(run.errLines().get(0).endsWith("(in frame 3)"), run.err());
        assertEquals(
                scene + ": 1 of all 4 frames cannot be used: 3", run.errLines().get(1));
        CliRun film = CliRun.of("animate", scene, "-o", folder.resolve("f/%d.png"), "--samples", "1");
        assertEquals(2, film.code());
        assertEquals(run.errLines().get(0), film.errLines().get(0).replaceFirst("^enlightenment: ", ""));
        assertFalse(Files.exists(folder.resolve("f")));
    }

    /** A sky's light is some ten times its radiance, a picture's as much as that. */
    @ParameterizedTest
    @ValueSource(strings = {"\"type\": \"sky\", \"elevation\": 30", "\"texture\": \"around\""})
    void surroundingsThatBecomeTooBrightAreFoundBeforeTheFilmIsBegun(String kind) throws IOException {
        float[] white = new float[24];
        Arrays.fill(white, 1);
        ImageFiles.writePng(new Image(4, 2, white, Color.Encoding.DISPLAY), folder.resolve("around.png"));
        Path scene = Files.writeString(
                folder.resolve("around.json"),
                """
                { "image": { "width": 8, "height": 8 },
                  "camera": { "type": "perspective", "eye": [0, 0, -5], "lookAt": [0, 0, 0], "fieldOfView": 40 },
                  "shading": { "model": "physical", "background": { %s, "radiance": 1 } },
                  "textures": { "around": { "file": "around.png" } }, "objects": [],
                  "animation": { "frames": 4, "framesPerSecond": 25,
                    "tracks": [{ "target": "/shading/background/radiance", "keys": { "0": 1, "2": 2, "3": 1e50 } }] } }
                """
                        .formatted(kind));
        CliRun run = CliRun.of("validate", scene);
        assertEquals(2, run.code());
        assertTrue(run.errLines().get(0).contains("/shading/background/radiance: times the light of the"), run.err());
        assertTrue(run.errLines().get(0).endsWith("(in frame 3)"), run.err());
        assertEquals(
                scene + ": 1 of all 4 frames cannot be used: 3", run.errLines().get(1));
        CliRun film = CliRun.of("animate", scene, "-o", folder.resolve("f/%d.png"), "--samples", "1");
        assertEquals(2, film.code());
        assertFalse(Files.exists(folder.resolve("f")));
    }

    /** Coordinates may be as far apart as numbers go, and farther: such a frame is valid, and a picture. */
    @Test
    void aFrameWhoseThingsAreFartherApartThanAnyNumberIsAPicture() throws IOException {
        Path scene = animated(
                """
                { "frames": 3, "framesPerSecond": 25,
                  "tracks": [{ "target": "/objects/0/center/0", "keys": { "0": 1, "2": 1.7e308 } },
                             { "target": "/camera/eye/0", "keys": { "0": 1, "2": -1.7e308 } },
                             { "target": "/camera/lookAt/0", "keys": { "0": 1, "2": -1.7e308 } } ] }
                """);
        assertEquals(new CliRun(0, scene + ": valid in all 3 frames\n", ""), CliRun.of("validate", scene));
        Path picture = folder.resolve("far.png");
        assertEquals(
                0, CliRun.of("render", scene, "--frame", "2", "-o", picture).code());
        assertTrue(Files.exists(picture));
    }

    @Test
    void ofVeryManyFramesThoseWithKeysAndSomeOthersAreLookedAt() throws IOException {
        Path scene = animated(
                """
                { "frames": 1000000, "framesPerSecond": 25,
                  "tracks": [{ "target": "/objects/0/radius",
                    "keys": { "0": 1, "123455": 1, "123456": -1, "123457": 1 } }] }
                """);
        CliRun run = CliRun.of("validate", scene);
        assertEquals(2, run.code());
        assertTrue(run.errLines().get(0).endsWith("(in frame 123456)"), run.err());
        assertTrue(
                run.errLines()
                        .get(1)
                        .matches(".*: 1 of \\d+ frames that were looked at, of 1000000 cannot be used: 123456"),
                run.err());
    }

    private static Animation animation(int frames, int... keys) {
        TreeMap<Integer, BigDecimal> values = new TreeMap<>();
        IntStream.of(keys).forEach(k -> values.put(k, BigDecimal.ONE));
        return new Animation(frames, 25, List.of(new Animation.Track("/a", values)));
    }

    @Test
    void theChoiceIsAllOrSpreadEvenlyWithTheEnds() {
        assertEquals(List.of(0), FrameChoice.of(animation(1, 0), 3000).frames());
        assertEquals(2000, FrameChoice.of(animation(2000, 0), 3000).frames().size());
        FrameChoice some = FrameChoice.of(animation(2_000_000_000, 7, 2_000_000_005), 3000);
        assertTrue(some.frames().size() > 1900 && some.frames().size() <= 2000, some.inWords());
        assertTrue(some.frames().containsAll(List.of(0, 7, 1_999_999_999)));
        int widest = IntStream.range(1, some.frames().size())
                .map(i -> some.frames().get(i) - some.frames().get(i - 1))
                .max()
                .orElseThrow();
        assertTrue(widest <= 2_000_000_000 / 1900, "at most " + widest + " from one to the next");
        // However large the scene, some frames are looked at; however many keys, some others are.
        int[] everywhere = IntStream.range(0, 5000).map(i -> 2 * i).toArray();
        List<Integer> few =
                FrameChoice.of(animation(10_000, everywhere), 1L << 40).frames();
        assertTrue(few.size() > 10 && few.size() <= 20, few.toString());
        assertEquals(0, few.get(0));
        assertEquals(9999, few.get(few.size() - 1));
    }

    @Test
    void neighboursAreToldAsRanges() {
        assertEquals("3", FrameChoice.ranges(List.of(3)));
        assertEquals("0..2, 5, 7..8", FrameChoice.ranges(List.of(0, 1, 2, 5, 7, 8)));
        List<Integer> many = IntStream.range(0, 30).map(i -> 2 * i).boxed().toList();
        assertEquals("0, 2, 4, 6, 8, 10, 12, 14, 16, 18 and more", FrameChoice.ranges(many));
    }
}
