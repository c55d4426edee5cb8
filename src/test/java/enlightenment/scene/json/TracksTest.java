package enlightenment.scene.json;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.scene.Animation;
import enlightenment.scene.json.tree.Numbers;
import java.math.BigDecimal;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;

/** Numbers between keys are as good as exact fractions that are rounded once, to a double. */
class TracksTest {
    private static BigDecimal at(int frame, String a, int length, String b) {
        return Tracks.valueAt(
                new Animation.Track("/", new TreeMap<>(Map.of(0, new BigDecimal(a), length, new BigDecimal(b)))),
                frame);
    }

    private static void assertValue(String expected, BigDecimal value) {
        assertEquals(0, new BigDecimal(expected).compareTo(value), () -> expected + " is not " + value);
    }

    @Test
    void decimalsAreExactHoweverLong() {
        assertValue("0.5", at(1, "0", 2, "1"));
        String long100 = "1234567890".repeat(10);
        assertValue("0." + long100 + "5", at(1, "0." + long100, 2, "0." + long100.substring(0, 99) + "1"));
        assertValue(
                "1e-700", at(7, "0", 10, "1").subtract(new BigDecimal("0.7")).add(new BigDecimal("1e-700")));
        // 3/1024 has ten decimals; a divisor of 3 · 2^k leaves none where the numerator is a multiple of 3.
        assertValue("0.0029296875", at(3, "0", 1024, "1"));
        assertValue("0.25", at(3, "0", 12, "1"));
        assertValue("1.7e308", at(5, "1.7e308", 7, "1.7e308"));
        assertValue("1e300", at(1, "0", 1_000_000_000, "1e309"));
    }

    /** Whatever two tracks differ by as fractions, they differ by: where that is a decimal, exactly. */
    @Test
    void differencesThatAreDecimalsStayThem() {
        Random random = new Random(5);
        for (int i = 0; i < 2_000; i++) {
            int length = 1 + random.nextInt(400);
            int frame = random.nextInt(length + 1);
            BigDecimal a = new BigDecimal(random.nextInt()).scaleByPowerOfTen(random.nextInt(600) - 300);
            BigDecimal b = new BigDecimal(random.nextInt()).scaleByPowerOfTen(random.nextInt(600) - 300);
            BigDecimal t = new BigDecimal(random.nextInt()).scaleByPowerOfTen(random.nextInt(600) - 300);
            BigDecimal value = at(frame, a.toString(), length, b.toString());
            BigDecimal moved = at(frame, a.add(t).toString(), length, b.add(t).toString());
            assertEquals(0, moved.subtract(value).compareTo(t), () -> a + " to " + b + " in " + length);
            // The same straight line with keys elsewhere, and the mirrored one that adds to a decimal with it.
            BigDecimal c = b.add(b).subtract(a);
            assertEquals(0, at(frame, a.toString(), 2 * length, c.toString()).compareTo(value));
        }
    }

    /** The nearest double of the cut number is that of the fraction: checked by comparing the fraction with the midpoints. */
    @Test
    void theNearestDoubleIsThatOfTheFraction() {
        Random random = new Random(6);
        for (int i = 0; i < 5_000; i++) {
            int length = 1 + random.nextInt(1000);
            int frame = random.nextInt(length + 1);
            BigDecimal a = BigDecimal.valueOf(random.nextLong(), random.nextInt(40));
            // Halfway between two doubles but for the last digit of a long decimal, or just any number.
            double d = random.nextDouble();
            BigDecimal middle = new BigDecimal(d).add(new BigDecimal(Math.ulp(d) / 2));
            BigDecimal goal = random.nextBoolean() ? middle : BigDecimal.valueOf(random.nextLong(), 19);
            BigDecimal off = random.nextInt(3) == 0 ? new BigDecimal("1e-500") : BigDecimal.ZERO;
            // a + (b − a)·frame/length = goal + off/3: keys in a third of the time.
            BigDecimal b = frame == 0
                    ? a
                    : a.add(goal.subtract(a).multiply(BigDecimal.valueOf(3L * length)))
                            .add(off);
            assertNearest(a, b, frame, 3 * length, at(frame, a.toString(), 3 * length, b.toString()));
        }
    }

    private static void assertNearest(BigDecimal a, BigDecimal b, int frame, int length, BigDecimal value) {
        double v = value.doubleValue();
        BigDecimal scaled = a.multiply(BigDecimal.valueOf(length - frame)).add(b.multiply(BigDecimal.valueOf(frame)));
        BigDecimal here = new BigDecimal(v);
        BigDecimal up = here.add(new BigDecimal(Math.nextUp(v))).multiply(BigDecimal.valueOf(length));
        BigDecimal down = here.add(new BigDecimal(Math.nextDown(v))).multiply(BigDecimal.valueOf(length));
        BigDecimal twice = scaled.add(scaled);
        assertTrue(
                twice.compareTo(up) <= 0 && twice.compareTo(down) >= 0,
                () -> "frame " + frame + " of " + a + " to " + b);
        boolean even = (Double.doubleToRawLongBits(v) & 1) == 0;
        assertTrue(even || twice.compareTo(up) < 0 && twice.compareTo(down) > 0, () -> "a tie at " + v);
    }

    private static Animation.Track smooth(String a, int length, String b) {
        return new Animation.Track(
                "/", new TreeMap<>(Map.of(0, new BigDecimal(a), length, new BigDecimal(b))), Animation.Easing.SMOOTH);
    }

    /** s²(3 − 2s) at 1/4, 1/2, 3/4: 5/32, 16/32, 27/32. */
    @Test
    void smoothMotionIsExactToo() {
        Animation.Track track = smooth("100", 8, "132");
        assertValue("100", Tracks.valueAt(track, 0));
        assertValue("105", Tracks.valueAt(track, 2));
        assertValue("116", Tracks.valueAt(track, 4));
        assertValue("127", Tracks.valueAt(track, 6));
        assertValue("132", Tracks.valueAt(track, 8));
        assertValue("132", Tracks.valueAt(track, 9));
        // 1/9 of 1 − 2/3 · 1/3 · ...: 7/27 at a third of the way.
        BigDecimal third = Tracks.valueAt(smooth("0", 3, "27"), 1);
        assertValue("7", third);
    }

    @Test
    void differencesOfSmoothMotionsThatAreDecimalsStayThem() {
        Random random = new Random(7);
        for (int i = 0; i < 500; i++) {
            int length = 1 + random.nextInt(400);
            int frame = random.nextInt(length + 1);
            BigDecimal a = new BigDecimal(random.nextInt()).scaleByPowerOfTen(random.nextInt(600) - 300);
            BigDecimal b = new BigDecimal(random.nextInt()).scaleByPowerOfTen(random.nextInt(600) - 300);
            BigDecimal t = new BigDecimal(random.nextInt()).scaleByPowerOfTen(random.nextInt(600) - 300);
            BigDecimal value = Tracks.valueAt(smooth(a.toString(), length, b.toString()), frame);
            BigDecimal moved =
                    Tracks.valueAt(smooth(a.add(t).toString(), length, b.add(t).toString()), frame);
            assertEquals(0, moved.subtract(value).compareTo(t), () -> a + " to " + b + " in " + length);
        }
    }

    /** Frame 3, half open, four instants: 3 + 1/16, 3/16, 5/16, 7/16. */
    @Test
    void instantsLieInTheMiddleOfEqualPartsOfTheTimeInWhichTheShutterIsOpen() {
        Animation.Track track =
                new Animation.Track("/", new TreeMap<>(Map.of(3, new BigDecimal("0"), 4, new BigDecimal("16"))));
        Animation animation = new Animation(10, 25, List.of(track), 0.5, 4);
        for (int i = 0; i < 4; i++) {
            assertValue("" + (2 * i + 1), Tracks.valueAt(track, Moment.instant(animation, 3, i)));
        }
        Animation thirds = new Animation(10, 25, List.of(track), 0.003, 3);
        assertValue("0.008", Tracks.valueAt(track, Moment.instant(thirds, 3, 0)));
    }

    @Test
    void everyNumberOfAFrameMayStandInAFile() {
        for (String largest : new String[] {"1.7e308", "-1.7e308", "4.9e-320", "0e-900"}) {
            String text = at(1, largest, 3, "-1").toString();
            assertNull(Numbers.objection(text), text);
        }
    }
}
