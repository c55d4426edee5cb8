package enlightenment.cli.measure;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.cli.CliRun;
import enlightenment.cli.SceneFixture;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** What a trade compares with, and what may be compared. */
class TradeReferenceCommandTest extends SceneFixture {
    private Path out;

    TradeReferenceCommandTest() {
        super(24, 16);
    }

    @BeforeEach
    void files() {
        out = folder.resolve("out");
    }

    private CliRun trade(Object... more) {
        List<Object> args = new ArrayList<>(List.of("trade", scene, "-o", out));
        args.addAll(List.of(more));
        return CliRun.of(args.toArray());
    }

    @Test
    void aReferenceOfAnotherSizeIsRefused() throws IOException {
        Path small = folder.resolve("small.pfm");
        assertEquals(
                0,
                CliRun.of("render", scene, "-o", small, "--size", "8x8", "--progress", "none")
                        .code());
        CliRun run = trade("--reference", small, "--budget", "1");
        assertEquals(2, run.code());
        assertTrue(run.err().contains("--reference must have 24x16 pixels, as the renders, not 8x8"), run.err());
    }

    @Test
    void aGivenReferenceIsJudgedAsWell() throws IOException {
        // Of so many pixels that their mean is within the tolerance.
        scene = CliRun.scene(folder, "\"width\": 48, \"height\": 32");
        Path rough = folder.resolve("rough.pfm");
        assertEquals(
                0,
                CliRun.of("render", scene, "-o", rough, "--samples", "4", "--seed", "99", "--progress", "none")
                        .code());
        assertEquals(
                0,
                trade("--reference", rough, "--methods", "raytrace,cluster", "--budget", "0.5", "--seeds", "1")
                        .code());
        String json = Files.readString(out.resolve("trade.json"));
        double stated =
                Double.parseDouble(json.replaceFirst("(?s).*\"reference\": \\{\\s*\"error\": ([^,]+),.*", "$1"));
        Path good = folder.resolve("good.pfm");
        assertEquals(
                0,
                CliRun.of("render", scene, "-o", good, "--samples", "256", "--progress", "none")
                        .code());
        String compared = CliRun.of("compare", rough, good, "--json").out();
        double true_ = Double.parseDouble(compared.replaceFirst("(?s).*\"rmse\": ([^,]+),.*", "$1"));
        assertEquals(true_, stated, 0.15 * true_);
    }

    /** A mirror, in which paths from lights show nothing: they are rendered and shown, but never advised. */
    @Test
    void whatCannotSeeAllOfASceneIsShownAndLeftOutOfTheAdvice() throws IOException {
        scene = Path.of("scenes/caustics.json");
        CliRun run = trade("--methods", "light,raytrace", "--size", "12x12", "--budget", "0.1", "--seeds", "1");
        assertEquals(0, run.code(), run.err());
        String leftOut = "Left out: light cannot see surfaces in mirrors";
        assertTrue(run.out().contains(leftOut), run.out());
        assertFalse(run.out().contains("--method light"), run.out());
        String page = Files.readString(out.resolve("index.html"));
        assertTrue(page.contains(leftOut) && page.contains("its errors include what is missing"), page.length() + "");
        assertTrue(
                Files.readString(out.resolve("trade.json")).matches("(?s).*\"leftOut\": \\[\\s*\"light cannot see.*"));
        String runs = Files.readString(out.resolve("trade.csv"));
        assertTrue(runs.contains("ladder,light,") && !runs.contains("check,light,"), runs);
        String measured = Files.readString(out.resolve("measured.txt"));
        assertTrue(measured.contains("reference.part=raytrace,0,") && !measured.contains("=light"), measured);
    }
}
