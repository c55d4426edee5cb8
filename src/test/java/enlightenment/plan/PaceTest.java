package enlightenment.plan;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.scene.RenderSettings;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** The arithmetic of time budgets, on machines of whatever speed and with whatever clocks. */
class PaceTest {
    private static final double[] EXTREMES = {
        0, Double.MIN_VALUE, 1e-300, 1e-9, 1e-3, 1, 1e9, 1e300, Double.MAX_VALUE, Double.POSITIVE_INFINITY
    };

    @Test
    void whateverTrialsTakeThereAreFinitelyManyAndTheNumberIsAPossibleOne() {
        for (double seconds : new double[] {Double.MIN_VALUE, 1e-300, 1e-9, 1e-3, 1, 1e9, Double.MAX_VALUE}) {
            for (double took : EXTREMES) {
                for (double step : EXTREMES) {
                    check(pace(seconds, 1 << 20, 4096), took, step, seconds + " s, " + took + " s, " + step + " s");
                }
                check(pace(seconds, 1, 1), took, -1, "a clock that runs backwards");
                check(pace(seconds, 1, 1), -took, 1, "a trial that ends before it begins");
                check(pace(seconds, 1, 1), Double.NaN, Double.NaN, "no clock");
                check(pace(seconds, 4e9, 64), took, 0, "a clock that stands still");
            }
        }
    }

    private static void check(Pace pace, double took, double step, String what) {
        double now = 0;
        int trials = 0;
        do {
            double n = pace.next();
            assertTrue(n >= 1 && n <= RenderSettings.Budget.MAX_SAMPLES, what + ": " + n);
            now += step;
            pace.tried(n, took, now);
            trials++;
            assertTrue(trials <= 10_000, what);
        } while (pace.isWorthTrying());
        double planned = Tidy.of(pace.planned(now));
        assertTrue(planned >= 1 && planned <= RenderSettings.Budget.MAX_SAMPLES, what + ": " + planned);
    }

    /** A machine that takes so many pixel samples per second, always: then the plan is what fits. */
    @Test
    void onASteadyMachineTheTimeIsUsedAndNotExceeded() {
        SplittableRandom random = new SplittableRandom(3);
        for (int i = 0; i < 1000; i++) {
            double speed = Math.pow(10, 3 + 6 * random.nextDouble());
            double pixels = Math.pow(10, 2 + 5 * random.nextDouble());
            double seconds = Math.pow(10, -2 + 6 * random.nextDouble());
            double trialPixels = Math.max(pixels / 16, 64);
            Pace pace = pace(seconds, pixels, trialPixels);
            double now = 0;
            do {
                double n = pace.next();
                double took = n * trialPixels / speed;
                now += took;
                pace.tried(n, took, now);
            } while (pace.isWorthTrying() && now < seconds);
            double planned = pace.planned(now);
            double fits = (seconds - now) * speed / pixels;
            // Before the third trial it hopes to become faster, by less than a fifth at that time.
            assertTrue(planned <= 1.1 * Math.max(fits, 0), planned + " where " + fits + " fit");
            assertTrue(planned >= 0.92 * fits, planned + " where " + fits + " fit");
        }
    }

    /** Whatever the time: an hour for what takes a second is no reason to try for minutes. */
    @Test
    void whereThereIsTimeForTwiceWhatIsWantedNothingMoreIsTried() {
        for (double seconds : new double[] {10, 3600, 1e9, Double.MAX_VALUE}) {
            Pace pace = new Pace(seconds, 1000, 100, 4);
            assertFalse(pace.isPlenty());
            pace.tried(pace.next(), 0.5, 0.5);
            assertTrue(pace.next() <= 4, pace.next() + " samples");
            // 200 samples of pixels per second: 8 per pixel take 40 seconds.
            assertEquals(seconds > 50, pace.isPlenty(), seconds + " s");
        }
    }

    private static Pace pace(double seconds, double pixels, double trialPixels) {
        return new Pace(seconds, pixels, trialPixels, RenderSettings.Budget.MAX_SAMPLES);
    }

    @Test
    void withoutAnyTrialNothingIsPlanned() {
        assertEquals(0, pace(1, 100, 10).planned(0));
        assertEquals(0, pace(1, 100, 10).planned(Double.POSITIVE_INFINITY));
        assertEquals(1, pace(1, 100, 10).next());
    }
}
