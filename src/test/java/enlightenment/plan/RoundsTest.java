package enlightenment.plan;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.render.TestScenes;
import enlightenment.report.RenderReport;
import enlightenment.scene.Method;
import enlightenment.scene.RenderSettings;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.DoubleUnaryOperator;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Pictures whose errors are known functions of the number of samples. */
class RoundsTest {
    private static final RenderSettings SETTINGS =
            RenderSettings.of(TestScenes.whiteFireAndIce().build());

    /** Samples per pixel of the rounds of a small picture of caustics. */
    private static final double[] SAMPLES = {1, 8, 64, 512, 4100};

    private static RenderReport report(RenderSettings.Budget budget, double samples, double error, double rounding) {
        return report(budget, samples, error / 1.2, error, rounding);
    }

    private static RenderReport report(
            RenderSettings.Budget budget, double samples, double told, double high, double rounding) {
        return report(SETTINGS.withBudget(budget), samples, told, high, rounding);
    }

    private static RenderReport report(
            RenderSettings settings, double samples, double told, double high, double rounding) {
        return report(settings, samples, told, high, rounding, Optional.empty());
    }

    private static RenderReport report(
            RenderSettings settings,
            double samples,
            double told,
            double high,
            double rounding,
            Optional<RenderReport.Light> light) {
        RenderReport.Sampling sampling = new RenderReport.Sampling(
                Method.RAYTRACE, "error", samples, samples, told, told / 1.2, high, 0, 0, 0, rounding, 1, light);
        return new RenderReport(
                "", settings, List.of(), Map.of(), 0, 0, sampling, Map.of(), Map.of(), 0, List.of(), 0, 0);
    }

    /** What all rounds took, and the number of the last. */
    private record End(double last, double all, int rounds, RenderReport report, String by) {}

    private static End render(RenderSettings.Budget budget, double first, DoubleUnaryOperator error, double rounding) {
        return render(budget, first, error, rounding, 0);
    }

    private static End render(
            RenderSettings.Budget budget, double first, DoubleUnaryOperator error, double rounding, double cost) {
        Rounds rounds = new Rounds(budget);
        double n = first;
        double all = 0;
        String by = "trial";
        for (int k = 1; ; k++) {
            assertTrue(k < 200, "there is no end to it");
            all += n;
            RenderReport report = report(budget, n, error.applyAsDouble(n), rounding);
            OptionalDouble next = rounds.next(report, cost * n, cost * all);
            if (next.isEmpty()) {
                return new End(n, all, k, report, by);
            }
            assertTrue(next.getAsDouble() > n, "no more than before");
            by = rounds.decidedBy(next.getAsDouble());
            n = next.getAsDouble();
        }
    }

    @Test
    void timeDecidesWhereAnErrorIsNotMetForWantOfIt() {
        RenderSettings.Budget both = RenderSettings.Budget.NONE.withError(0.01).withSeconds(10);
        Rounds rounds = new Rounds(both);
        RenderReport late = report(both, 8, 0.05, 0);
        assertTrue(rounds.next(late, 6, 9.9).isEmpty(), "there is no time for a second picture");
        assertEquals("time", late.decidedBy());
        assertEquals("error", report(both, 800, 0.009, 0).decidedBy());
        assertEquals(
                "error",
                report(RenderSettings.Budget.NONE.withError(0.01), 8, 0.05, 0).decidedBy());
    }

    /** Samples that all missed some light agree without it. */
    @Test
    void fewSamplesDoNotMeetAnErrorWhereLightIsUndersampled() {
        RenderSettings.Budget asked = RenderSettings.Budget.NONE.withError(0.01);
        Optional<RenderReport.Light> light =
                Optional.of(new RenderReport.Light(0.1, 9, false, 0, List.of("few paths")));
        RenderReport few = report(SETTINGS.withBudget(asked), 8, 0.004, 0.005, 0, light);
        assertEquals(64, new Rounds(asked).next(few, 1, 2).orElseThrow());
        assertTrue(new Rounds(asked).note(few, 64).startsWith("8 samples per pixel are too few to tell the error"));
        RenderReport enough = report(SETTINGS.withBudget(asked), 64, 0.004, 0.005, 0, light);
        assertTrue(new Rounds(asked).next(enough, 1, 2).isEmpty());
        RenderSettings.Budget limited = asked.withSamples(32);
        assertEquals(32, new Rounds(limited).next(few, 1, 2).orElseThrow());
        RenderReport told = report(SETTINGS.withBudget(asked), 8, 0.004, 0.005, 0);
        assertTrue(new Rounds(asked).next(told, 1, 2).isEmpty());
    }

    /** A little more is much more where it is the least that the method can do with. */
    @Test
    void withTimeLeftARoundOfTheMethodItselfFollowsThatOfTheMethodForFewSamples() {
        RenderSettings.Budget both = RenderSettings.Budget.NONE.withError(0.01).withSeconds(100);
        MethodTraits traits = Integrators.traits(Method.CLUSTER, SETTINGS, false);
        RenderSettings settings = SETTINGS.withMethod(Method.CLUSTER).withBudget(both);
        RenderReport few = report(settings, traits.mostBelow(), 0.04, 0.05, 0);
        assertEquals(traits.first(), new Rounds(both).next(few, 1, 2).orElseThrow());
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.5, 0.6, 0.75, 1})
    void theErrorIsKeptInAFewRoundsAndNotWastefully(double slope) {
        for (double asked = 0.2; asked > 1e-3; asked *= 0.77) {
            for (double first : new double[] {1, 2.44, 30}) {
                DoubleUnaryOperator error = n -> 0.3 * Math.pow(n, -slope);
                End end = render(RenderSettings.Budget.NONE.withError(asked), first, error, 0);
                assertTrue(end.report.isErrorMet());
                double needed = Math.max(Math.pow(0.3 / asked, 1 / slope), first);
                assertTrue(end.last <= 2 * needed, end + " where " + needed + " are needed");
                assertTrue(end.all <= 4 * needed, end + " where " + needed + " are needed");
            }
        }
    }

    @Test
    void whateverTheErrorIsItEnds() {
        List<DoubleUnaryOperator> errors = List.of(
                n -> 0.1,
                n -> 0.1 * n,
                n -> Double.POSITIVE_INFINITY,
                n -> Double.NaN,
                n -> n % 2 == 0 ? 0.02 : 1e300,
                n -> 0.1 + 1e-9 / n);
        for (DoubleUnaryOperator error : errors) {
            for (double asked : new double[] {Double.MIN_VALUE, 1e-300, 1e-7, 0.01}) {
                for (double rounding : new double[] {0, 1e-9, 0.0011, 0.01, 1, Double.NaN}) {
                    for (double first : new double[] {1, 2.45, RenderSettings.Budget.MAX_SAMPLES}) {
                        RenderSettings.Budget budget = RenderSettings.Budget.NONE.withError(asked);
                        assertFalse(
                                render(budget, first, error, rounding).report.isErrorMet());
                        render(budget.withSamples(57.3), Math.min(first, 57.3), error, rounding);
                        for (double cost : new double[] {0, Double.MIN_VALUE, 1e-3, 1e9, Double.NaN}) {
                            render(budget.withSeconds(2), first, error, rounding, cost);
                        }
                    }
                }
            }
        }
    }

    @Test
    void theSamplesThatAreAllowedAreAllTriedAndNotExceeded() {
        DoubleUnaryOperator error = n -> 1 / Math.sqrt(n);
        End end = render(RenderSettings.Budget.NONE.withError(0.01).withSamples(123.4), 1, error, 0);
        assertEquals(123.4, end.last);
        assertEquals("samples", end.by);
        assertFalse(end.report.isErrorMet());
        assertTrue(Rounds.samplesForError(end.report).getAsDouble() > 123.4);
        assertEquals(1, render(RenderSettings.Budget.NONE.withError(0.01).withSamples(1), 1, error, 0).rounds);
    }

    /** Whatever the picture has: eight times as many were the most that was told. */
    @Test
    void theSamplesThatAreAdvisedAreEnoughForIndependentSamples() {
        for (double n : new double[] {1, 3, 64, 1000}) {
            End end = render(RenderSettings.Budget.NONE.withError(0.01).withSamples(n), n, k -> 1 / Math.sqrt(k), 0);
            double advised = Rounds.samplesForError(end.report).getAsDouble();
            assertTrue(advised >= 1e4 && advised <= 1.2e4, advised + " after " + n);
        }
    }

    @Test
    void theTimeIsNotExceeded() {
        for (double seconds = 0.01; seconds < 1000; seconds *= 1.9) {
            End end = render(
                    RenderSettings.Budget.NONE.withError(1e-4).withSeconds(seconds),
                    1,
                    n -> 1 / Math.sqrt(n),
                    0,
                    0.001);
            assertTrue(end.all * 0.001 <= seconds, end + " in " + seconds + " s");
            assertTrue(end.rounds == 1 || end.by.equals("time") || end.by.equals("error"), end.by);
        }
    }

    /** What rounding takes of the error, samples must make up for. */
    @Test
    void roundingIsPartOfTheErrorAndEndsItWhereItIsAllOfIt() {
        DoubleUnaryOperator error = n -> 0.1 / Math.sqrt(n);
        End plain = render(RenderSettings.Budget.NONE.withError(0.002), 1, error, 0);
        End rounded = render(RenderSettings.Budget.NONE.withError(0.002), 1, error, 0.0015);
        assertTrue(rounded.last > 2 * plain.last);
        assertTrue(Math.hypot(error.applyAsDouble(rounded.last), 0.0015) <= 0.002);
        assertEquals(1, render(RenderSettings.Budget.NONE.withError(0.0014), 1, error, 0.0015).rounds);
        // Another limit ends it, too, and the picture is as good as that allows.
        assertEquals(
                77.7, render(RenderSettings.Budget.NONE.withError(0.0014).withSamples(77.7), 1, error, 0.0015).last);
    }

    @Test
    void anIntervalThatReachesBeyondTheErrorIsNotMet() {
        RenderSettings.Budget budget = RenderSettings.Budget.NONE.withError(0.01);
        assertTrue(report(budget, 4, 0.0099, 0).isErrorMet());
        assertTrue(report(budget, 4, 0.0099, 0.0011).isErrorMet());
        assertFalse(report(budget, 4, 0.0099, 0.0015).isErrorMet());
        // The estimate alone would be 0.0084.
        assertFalse(report(budget, 4, 0.0101, 0).isErrorMet());
    }

    private static void assertGoesOn(double asked, double[] told, double[] high) {
        RenderSettings.Budget budget = RenderSettings.Budget.NONE.withError(asked);
        Rounds rounds = new Rounds(budget);
        for (int k = 0; k < high.length; k++) {
            RenderReport report = report(budget, SAMPLES[k], told[k], high[k], 0);
            assertTrue(rounds.next(report, 0, 0).isPresent(), "round " + (k + 1));
        }
    }

    /** The upper ends of a small picture of caustics, where rare bright samples come up first with 512 samples per pixel. */
    @Test
    void anErrorThatJumpsUpOnceIsNotGivenUp() {
        double[] errors = {0.206, 0.0683, 0.0389, 0.104, 0.0575};
        assertGoesOn(0.01, Arrays.stream(errors).map(e -> e / 1.2).toArray(), errors);
    }

    /** The same picture with half of the error: by its upper ends independent samples would need 840,000, by what is told 86,000. */
    @Test
    void anIntervalThatIsWideEndsNoSearchWhoseErrorIsNear() {
        double[] told = {0.05, 0.026, 0.0162, 0.027, 0.0216};
        double[] high = {0.206, 0.0683, 0.0389, 0.104, 0.068};
        assertGoesOn(0.005, told, high);
    }

    /** The error of light paths in a scene of narrow lobes: it falls as n^-0.14, and a tenth of it is asked for. */
    @Test
    void anErrorThatHardlyFallsIsGivenUpUnlessSomethingElseLimitsTheRender() {
        DoubleUnaryOperator error = n -> 0.6 * Math.pow(n, -0.14);
        Rounds rounds = new Rounds(RenderSettings.Budget.NONE.withError(0.02));
        double n = 4;
        double all = 0;
        for (OptionalDouble next = OptionalDouble.of(n); next.isPresent(); ) {
            assertTrue(rounds.reasonForStopping().isEmpty());
            n = next.getAsDouble();
            all += n;
            next = rounds.next(report(RenderSettings.Budget.NONE.withError(0.02), n, error.applyAsDouble(n), 0), 0, 0);
        }
        // The first round that tells something has 256, and 64 times as many are enough.
        assertTrue(n >= 64 * 64 && all < 20_000, n + " of " + all);
        assertTrue(rounds.reasonForStopping().orElseThrow().contains("hardly fallen"));
        RenderSettings.Budget limited =
                RenderSettings.Budget.NONE.withError(0.02).withSamples(100_000);
        assertEquals(100_000, render(limited, 4, error, 0).last);
    }

    @Test
    void whatAFewSamplesTellEndsNoSearch() {
        // Upper ends with few samples are too low, or hardly fall; from 64 on the error falls as it should.
        DoubleUnaryOperator error = n -> n < 64 ? 0.15 : 1.2 / Math.sqrt(n);
        End end = render(RenderSettings.Budget.NONE.withError(0.02), 1, error, 0);
        assertTrue(error.applyAsDouble(end.last) <= 0.02, end.last + " samples");
    }
}
