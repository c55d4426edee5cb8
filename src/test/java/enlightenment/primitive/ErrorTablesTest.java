package enlightenment.primitive;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.FieldSource;

/** What the tables of docs/notes/numerics-tables.md must show: our column keeps the promises, the textbook's does not. */
class ErrorTablesTest {
    static final List<String> KINDS = Subject.KINDS;

    /** The kinds that the shipped vectors have. */
    static final List<String> VECTOR_KINDS = List.of("sphere", "cylinder", "cone", "torus");

    static final List<String> SOLID_KINDS =
            KINDS.stream().filter(k -> !k.equals("triangle")).toList();

    private static void checkOurs(ErrorTally tally, String what) {
        assertTrue(tally.decided > tally.rays / 2, what);
        assertEquals(0, tally.wrong[ErrorTally.OURS], what + ": wrong");
        assertEquals(0, tally.tOff[ErrorTally.OURS], what + ": t off");
        assertTrue(tally.ulps[ErrorTally.OURS] <= 8, what + ": " + tally.ulps[ErrorTally.OURS] + " ulp");
    }

    @ParameterizedTest
    @FieldSource("KINDS")
    void oursIsRightWhereverRaysStart(String kind) {
        checkGenerated(kind, 12);
    }

    @Tag("full")
    @ParameterizedTest
    @FieldSource("KINDS")
    void oursIsRightWhereverManyRaysStart(String kind) {
        checkGenerated(kind, 30);
    }

    private static void checkGenerated(String kind, int rays) {
        int naive = 0;
        for (ErrorTables.Scenario scenario : ErrorTables.SCENARIOS) {
            ErrorTally tally = ErrorTables.generated(kind, scenario, rays);
            checkOurs(tally, kind + ", " + scenario.name());
            naive += tally.wrong[ErrorTally.NAIVE] + (tally.ulps[ErrorTally.NAIVE] > 8 ? 1 : 0);
        }
        assertTrue(naive > 0, "the textbook's form has its errors too");
    }

    @ParameterizedTest
    @FieldSource("VECTOR_KINDS")
    void oursIsRightOnTheShippedVectors(String kind) {
        ErrorTally tally = ErrorTables.vectors(kind);
        assertTrue(tally.rays > 50, tally.rays + " vectors");
        checkOurs(tally, kind);
        assertTrue(tally.wrong[ErrorTally.NAIVE] > 0, kind);
    }

    @Test
    void oursNeitherLeaksNorMissesFaces() {
        int[] leaks = ErrorTables.leaks(0, "vertices", 500);
        assertEquals(0, leaks[ErrorTally.OURS]);
        assertTrue(leaks[ErrorTally.NAIVE] > 0);
        for (int fixed = 1; fixed <= 2; fixed++) {
            assertArrayEquals(new int[] {1000, 0}, ErrorTables.faces(fixed, 1000));
        }
    }

    @ParameterizedTest
    @FieldSource("SOLID_KINDS")
    void oursNeitherLosesAnExitNorHitsItself(String kind) {
        for (double size : new double[] {1e-3, 1e6}) {
            int[][] counts = ErrorTables.leaving(kind, size, 0, 100);
            assertEquals(0, counts[0][ErrorTally.OURS], kind + ": lost exits");
            assertEquals(0, counts[1][ErrorTally.OURS], kind + ": self-hits");
        }
    }

    @Tag("full")
    @Test
    void theDocumentIsWhatTheCommandWrites() throws IOException {
        Path document = Path.of(System.getProperty("project.directory"), "docs", "notes", "numerics-tables.md");
        assertEquals(Files.readString(document), ErrorTables.text());
    }
}
