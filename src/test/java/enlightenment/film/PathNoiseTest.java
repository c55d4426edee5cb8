package enlightenment.film;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.color.DisplayCurve;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** What films of linear light tell of their errors, on pictures of noise as paths make it, whose truth is known. */
class PathNoiseTest {
    private static final double DARK = 0.05;
    private static final double USUAL = 0.5;
    private static final double BURNT_OUT = 4;

    @ParameterizedTest
    @EnumSource(PathPicture.Kind.class)
    void theIntervalHoldsTheErrorThatIsSeenOrTheReportWarns(PathPicture.Kind kind) {
        check(kind, new int[] {1, 2, 3, 4, 5, 8, 16}, DisplayCurve.SRGB, 2);
    }

    @Tag("full")
    @ParameterizedTest
    @EnumSource(PathPicture.Kind.class)
    void itDoesSoOnManySeeds(PathPicture.Kind kind) {
        check(kind, new int[] {1, 2, 3, 4, 5, 6, 8, 11, 16, 32, 64, 256}, DisplayCurve.SRGB, 20);
        check(kind, new int[] {4, 16, 64}, DisplayCurve.of(-1.5, DisplayCurve.Tone.FILMIC), 20);
    }

    private static void check(PathPicture.Kind kind, int[] counts, DisplayCurve curve, int seeds) {
        int pictures = 0;
        List<String> wrong = new ArrayList<>();
        for (double brightest : new double[] {DARK, USUAL, BURNT_OUT}) {
            for (int n : counts) {
                // Two of what a screen shows only as black or white tell nothing; of a single sample nobody can.
                if (n < 4 && (brightest == BURNT_OUT || kind == PathPicture.Kind.SPARKS)) {
                    continue;
                }
                for (int seed = 0; seed < seeds; seed++) {
                    PathPicture picture = PathPicture.of(kind, brightest, n, curve, seed);
                    ErrorEstimate error = picture.film.error();
                    boolean isWarned = error.linear().orElseThrow().hasHeavyTail();
                    pictures++;
                    if (!isWarned && (picture.error() > error.high() || picture.error() < error.low())) {
                        wrong.add(brightest + ", " + n + " samples: " + picture.error() + " not in " + error.low()
                                + ".." + error.high());
                    }
                }
            }
        }
        assertTrue(wrong.size() <= 0.05 * pictures, () -> wrong.toString());
    }

    @ParameterizedTest
    @EnumSource(
            value = PathPicture.Kind.class,
            names = {"EXPONENTIAL", "SLIGHT", "HEAVY"})
    void theRelativeErrorOfLightIsThatOfItsDefinition(PathPicture.Kind kind) {
        for (int n : new int[] {8, 16, 64}) {
            PathPicture picture = PathPicture.of(kind, USUAL, n, DisplayCurve.SRGB, 1);
            double told = picture.film.error().linear().orElseThrow().relative();
            assertEquals(1, told / picture.relative(), 0.2, n + " samples");
        }
    }

    @Test
    void sparksAreWarnedOfAndOrdinaryNoiseIsNot() {
        for (int n : new int[] {4, 16, 64}) {
            assertTrue(error(PathPicture.Kind.SPARKS, BURNT_OUT, n).hasHeavyTail(), n + " samples");
            assertFalse(error(PathPicture.Kind.EXPONENTIAL, BURNT_OUT, n).hasHeavyTail(), n + " samples");
            assertFalse(error(PathPicture.Kind.HEAVY, USUAL, n).hasHeavyTail(), n + " samples");
        }
    }

    private static LinearError error(PathPicture.Kind kind, double brightest, int samples) {
        return PathPicture.of(kind, brightest, samples, DisplayCurve.SRGB, 3)
                .film
                .error()
                .linear()
                .orElseThrow();
    }

    @Test
    void aSingleSampleTellsNoRelativeError() {
        assertTrue(Double.isNaN(error(PathPicture.Kind.SLIGHT, USUAL, 1).relative()));
    }
}
