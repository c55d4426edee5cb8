package enlightenment.photometry;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** IES files: what they hold by the rules of their symmetry, computed by hand, and what is refused with its line. */
class IesFileTest {
    private static final String HEAD =
            "IESNA:LM-63-2002\n[TEST] none\n[LUMINAIRE] two lines\n[MORE] of it\nTILT=NONE\n";

    private static IntensityTable read(String text) throws IOException {
        return IesFile.of(text.getBytes(StandardCharsets.ISO_8859_1));
    }

    /** A table of the vertical angles 0 and 90. */
    private static IntensityTable table(String horizontal, String candela) throws IOException {
        int planes = horizontal.split(" ").length;
        return read(HEAD + "1 -1 1 2 " + planes + " 1 2 0 0 0\n1 1 40\n0 90\n" + horizontal + "\n" + candela + "\n");
    }

    private static void assertAt(double expected, IntensityTable table, double fromNadir, double around) {
        assertEquals(expected, table.candela(fromNadir, around), 1e-12 * Math.abs(expected));
    }

    @Test
    void onePlaneIsAlikeAllAround() throws IOException {
        IntensityTable t = table("0", "100 40");
        for (double around : new double[] {0, 17, 180, 359.5, 360}) {
            assertAt(100, t, 0, around);
            assertAt(70, t, 45, around);
            assertAt(40, t, 90, around);
            assertAt(0, t, 90.1, around);
        }
        assertEquals(100, t.largest());
    }

    /** At 90 degrees from the nadir 10, 20 and 40 at 0, 45 and 90 degrees. */
    @Test
    void aQuarterIsMirroredTwice() throws IOException {
        IntensityTable t = table("0 45 90", "1 10 1 20 1 40");
        double[][] expected = {
            {0, 10},
            {22.5, 15},
            {45, 20},
            {90, 40},
            {112.5, 30},
            {135, 20},
            {180, 10},
            {225, 20},
            {270, 40},
            {315, 20},
            {360, 10}
        };
        for (double[] e : expected) {
            assertAt(e[1], t, 90, e[0]);
        }
    }

    @Test
    void aHalfIsMirroredAtItsPlane() throws IOException {
        IntensityTable t = table("0 60 180", "1 10 1 40 1 20");
        double[][] expected = {
            {0, 10}, {30, 25}, {60, 40}, {120, 30}, {180, 20}, {240, 30}, {300, 40}, {330, 25}, {360, 10}
        };
        for (double[] e : expected) {
            assertAt(e[1], t, 90, e[0]);
        }
    }

    @Test
    void allPlanesAreTakenAsTheyAre() throws IOException {
        IntensityTable t = table("0 90 180 270 360", "1 10 1 20 1 30 1 40 1 10");
        double[][] expected = {{0, 10}, {45, 15}, {135, 25}, {270, 40}, {315, 25}, {360, 10}};
        for (double[] e : expected) {
            assertAt(e[1], t, 90, e[0]);
        }
    }

    @Test
    void aHalfFromNinetyDegreesIsMirroredAcross() throws IOException {
        IntensityTable t = table("90 150 180 270", "1 10 1 16 1 40 1 20");
        double[][] expected = {
            {0, 40}, {15, 28}, {30, 16}, {90, 10}, {150, 16}, {180, 40}, {270, 20}, {315, 30}, {360, 40}
        };
        for (double[] e : expected) {
            assertAt(e[1], t, 90, e[0]);
        }
    }

    @Test
    void intensitiesAreBilinear() throws IOException {
        IntensityTable t = table("0 90 180 270 360", "0 8 0 16 0 8 0 8 0 8");
        assertAt(0.25 * 8 * (1 - 1.0 / 3) + 0.25 * 16 / 3, t, 22.5, 30);
    }

    @ParameterizedTest
    @CsvSource({"IESNA:LM-63-2002, 6", "IESNA:LM-63-1995, 6", "IES:LM-63-2019, 6", "IESNA91, 24", "IESNA:LM-63-1991, 24"
    })
    void factorsMultiplyIntensities(String standard, double expected) throws IOException {
        String text = standard + "\r\n[TEST]\r\nTILT=NONE\r\n1 800 3 2 1 1 1 0 0 0\r\n2 4 40\r\n0 90\r\n0\r\n1 1\r\n";
        assertEquals(expected, read(text).largest());
    }

    @Test
    void filesOfTheFirstStandardHaveNoNameOfIt() throws IOException {
        assertEquals(
                24,
                read("Any text\nTILT=NONE\n1 800 3 2 1 1 1 0 0 0\n2 4 40\n0 90\n0\n1 1")
                        .largest());
    }

    @Test
    void factorsOfTiltedLampsArePassedOver() throws IOException {
        String tilt = HEAD.replace("NONE", "INCLUDE") + "1\n3\n0 45 90\n1 .9 .8\n";
        assertEquals(
                5, read(tilt + "1 1 1 2 1 1 2 0 0 0 1 1 1 0,90\n0, 5,\t1e0").largest());
    }

    /** What is expected, by a part of the message. */
    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "1 1 1 2 1 2 2 0 0 0 1 1 1 0 90 0 5 1 | line 6: has photometry of type B; only type C can be read",
                "1 1 1 2 1 3 2 0 0 0 1 1 1 0 90 0 5 1 | line 6: has photometry of type A; only type C can be read",
                "1 1 1 2 1 1 2 0 0 0 1 1 1 0 90 0 5 | line 6: ends where an intensity is expected",
                "1 1 1 2 1 1 2 0 0 0 1 1 1 0 90 0 5 -1 | line 6: has -1.0 for an intensity, which is at least 0",
                "1 1 1 2 1 1 2 0 0 0 1 1 1 0 90 0 5 x1 | line 6: has \"x1\" where an intensity is expected, a number",
                "1 1 1 2 1 1 2 0 0 0 1 1 1 90 0 0 5 1 | line 6: has a vertical angle of 0.0; angles ascend and are at most 180.0",
                "1 1 1 2 1 1 2 0 0 0 1 1 1 0 190 0 5 1 | line 6: has a vertical angle of 190.0; angles ascend and are at most 180.0",
                "1 1 1 2 2 1 2 0 0 0 1 1 1 0 90 0 45 5 1 5 1 | line 6: has horizontal angles from 0.0 to 45.0; they are one alone,",
                "1 1 1 2000000000 2000000000 1 2 | line 6: has 2.0E9 for the number of vertical angles, a whole number in 2..18001",
                "1 1 1 2 9999 1 2 | line 6: has 9999.0 for the number of horizontal angles, a whole number in 1..3601",
                "1 1 1 2.5 1 1 2 | line 6: has 2.5 for the number of vertical angles, a whole number",
                "1 1 1 2 1 1 2 0 0 0 1 1 1 0 90 0 5 1e999 | line 6: has \"1e999\" for an intensity, beyond the range of doubles",
                "1 1 1e300 2 1 1 2 0 0 0 1 1 1 0 90 0 5 1e300 | line 6: has an intensity beyond the range of doubles"
            })
    void whatIsWrongIsRefusedWithItsLine(String numbers, String message) {
        IOException e = assertThrows(IOException.class, () -> read(HEAD + numbers));
        assertTrue(e.getMessage().startsWith(message), e.getMessage());
    }

    @Test
    void aTextWithoutNumbersIsRefused(@TempDir Path folder) throws IOException {
        assertThrows(IOException.class, () -> read(""));
        Path file = Files.writeString(folder.resolve("a.ies"), "IESNA:LM-63-2002\n[A] b\n");
        String message =
                assertThrows(IOException.class, () -> IesFile.read(file)).getMessage();
        assertTrue(
                message.contains("a.ies") && message.contains("line 2: has no line that begins with \"TILT=\""),
                message);
    }

    /** Texts that were cut, and with bytes that are others: read, or refused with a line, and nothing else. */
    @Test
    void damagedFilesAreReadOrRefused() {
        byte[] right = (HEAD + "1 -1 1 3 3 1 2 0 0 0\n1 1 40\n0 45 90\n0 45 90\n9 8 7\n6 5 4\n3 2 1\n")
                .getBytes(StandardCharsets.ISO_8859_1);
        SplittableRandom random = new SplittableRandom(1);
        int refused = 0;
        for (int i = 0; i < 20_000; i++) {
            byte[] bytes = java.util.Arrays.copyOf(right, i % 2 == 0 ? right.length : random.nextInt(right.length));
            for (int k = random.nextInt(4); k > 0 && bytes.length > 0; k--) {
                bytes[random.nextInt(bytes.length)] = (byte) random.nextInt(256);
            }
            try {
                assertTrue(IesFile.of(bytes).largest() >= 0);
            } catch (IOException e) {
                refused++;
                assertTrue(e.getMessage().matches("line [0-9]+: [^\\p{Cntrl}]{1,200}"), e.getMessage());
            }
        }
        assertTrue(refused > 5000, refused + " of 20000");
    }
}
