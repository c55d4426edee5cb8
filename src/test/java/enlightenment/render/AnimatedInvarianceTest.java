package enlightenment.render;

import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.json.SceneReader;
import java.io.IOException;
import java.math.BigDecimal;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** N03 for scenes that move: a decimal added to every position, those of the keys included, changes no bit of any frame. */
class AnimatedInvarianceTest {
    /** Keys seven frames apart: sevenths, which no decimals are. */
    private static final int LENGTH = 7;

    @TempDir
    Path folder;

    private RawPicture picture(String text, int frame) throws IOException {
        Scene scene = SceneReader.read(Files.writeString(folder.resolve("scene.json"), text), frame);
        return RawPicture.of(scene, RenderSettings.of(scene).withThreads(1));
    }

    private static String track(String target, BigDecimal t, String from, String to) {
        return "{ \"target\": \"" + target + "\", \"keys\": { \"0\": " + new BigDecimal(from).add(t) + ", \"" + LENGTH
                + "\": " + new BigDecimal(to).add(t) + " } }";
    }

    private static String animated(String scene, String... tracks) {
        return scene.replaceFirst(
                "\\{",
                "{ \"animation\": { \"frames\": 8, \"framesPerSecond\": 25, \"tracks\": [" + String.join(", ", tracks)
                        + "] },");
    }

    @ParameterizedTest
    @ValueSource(strings = {"1e3", "1e15", "1e30", "-1234567.000000000000000000000000000000891"})
    void aSceneMovedByADecimalGivesTheSameBitsInEveryFrame(String decimal) throws IOException {
        BigDecimal zero = BigDecimal.ZERO;
        BigDecimal t = new BigDecimal(decimal);
        for (int frame : new int[] {1, 5}) {
            picture(reference(zero), frame).assertSameBits(picture(reference(t), frame), decimal + ", frame " + frame);
        }
    }

    private static String reference(BigDecimal t) {
        return animated(
                ReferenceScene.seenBy(ReferenceScene.GENERIC).get(0).translatedText(t),
                track("/camera/eye/0", t, "0.3137", "1.5"),
                track("/camera/eye/1", t, "2.7", "2.9"),
                track("/camera/lookAt/2", t, "4", "3.9"),
                track("/objects/2/center/1", t, "2.1", "3"),
                track("/lights/0/center/2", t, "-1.1", "1"));
    }

    /** Eye and ball travel together, and between the keys the first digits of their places are the same. */
    @ParameterizedTest
    @ValueSource(strings = {"1e15", "-1e30", "1e-40"})
    void aTinyThingThatTravelsWithTheEyeStaysWhereItIs(String decimal) throws IOException {
        for (int frame : new int[] {1, 2, 7}) {
            RawPicture here = picture(companions(BigDecimal.ZERO), frame);
            here.assertSameBits(picture(companions(new BigDecimal(decimal)), frame), decimal + ", frame " + frame);
            here.assertSameBits(picture(companions(BigDecimal.ZERO), 0), "at rest, frame " + frame);
        }
    }

    private static String companions(BigDecimal t) {
        String eye = "[" + t + ", " + t + ", " + t + "]";
        String at = "[" + t.add(new BigDecimal("2e-31")) + ", " + t + ", " + t.add(new BigDecimal("5e-30")) + "]";
        String scene =
                "{ \"image\": { \"width\": 16, \"height\": 12 }, \"camera\": { \"type\": \"perspective\", \"eye\": "
                        + eye + ", \"lookAt\": " + at + ", \"up\": [0, 1, 0], \"fieldOfView\": 40 },"
                        + "\"lights\": [ { \"type\": \"point\", \"position\": " + eye + ", \"color\": \"#ffffff\" } ],"
                        + "\"objects\": [ { \"type\": \"sphere\", \"center\": " + at + ", \"radius\": 1e-30,"
                        + " \"material\": { \"type\": \"matte\", \"color\": \"#c08040\" } } ] }";
        return animated(
                scene,
                track("/camera/eye/0", t, "0", "1"),
                track("/camera/lookAt/0", t, "2e-31", "1." + "0".repeat(30) + "2"),
                track("/objects/0/center/0", t, "2e-31", "1." + "0".repeat(30) + "2"),
                track("/lights/0/position/0", t, "0", "1"));
    }
}
