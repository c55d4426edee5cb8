package enlightenment.render;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.render.ManySeeds.Picture;
import enlightenment.report.RenderReport;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.ClassicMethods;
import enlightenment.scene.Method;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.Shading;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** A budget is kept, says which part of it was decisive, and can be written as a number of samples. */
class PlannerTest {
    private static RenderSettings settings(Scene scene, Method method, int width, int height) {
        return RenderSettings.of(scene)
                .withMethod(method)
                .withSize(width, height)
                .withThreads(2);
    }

    /** With as many rounds as it takes. */
    private static RenderResult render(Scene scene, RenderSettings settings) {
        return Renderer.render(RenderRequest.of(scene, settings));
    }

    private static double[] doubles(RenderResult result) {
        float[] floats = result.image().toArray();
        double[] doubles = new double[floats.length];
        Arrays.setAll(doubles, k -> floats[k]);
        return doubles;
    }

    private static double distance(RenderResult a, double[] b) {
        return distance(doubles(a), b);
    }

    private static double distance(double[] a, double[] b) {
        double sum = 0;
        for (int k = 0; k < a.length; k++) {
            sum += (a[k] - b[k]) * (a[k] - b[k]);
        }
        return Math.sqrt(sum / a.length);
    }

    /** A picture of the other method, far more exact than what is compared with it. */
    private static double[] reference(Scene scene, Method method, int width, int height, double error) {
        Method other = method == Method.CLUSTER ? Method.RAYTRACE : Method.CLUSTER;
        RenderSettings s = settings(scene, other, width, height).withSeed(424242);
        return doubles(render(scene, s.withBudget(RenderSettings.Budget.NONE.withError(error))));
    }

    @ParameterizedTest
    @CsvSource({"cylinders, CLUSTER", "glass, CLUSTER", "keyhole, CLUSTER", "keyhole, RAYTRACE"})
    void theTrueErrorStaysBelowWhatWasAsked(String name, BuiltInMethod method) {
        assertBelow(name, method, 48, 24);
    }

    private static void assertBelow(String name, Method method, int width, int height) {
        Scene scene = ManySeeds.shipped(name);
        double asked = 0.03;
        // A quarter: what the reference errs itself adds 3 % to the distance, on the side of caution.
        double[] truth = reference(scene, method, width, height, asked / 4);
        RenderSettings s =
                settings(scene, method, width, height).withBudget(RenderSettings.Budget.NONE.withError(asked));
        int over = 0;
        int runs = 6;
        for (int seed = 0; seed < runs; seed++) {
            RenderResult p = render(scene, s.withSeed(seed));
            over += distance(p, truth) > asked ? 1 : 0;
            assertTrue(p.report().isErrorMet());
        }
        assertTrue(over <= 1, over + " of " + runs + " pictures are worse than asked");
    }

    /** With a survey the error of these scenes is at once a twentieth of what it is without. */
    @ParameterizedTest
    @CsvSource({"cylinders, 0.01", "cone, 0.01"})
    void theJumpOfTheErrorWhereSurveysBeginDoesNotMisleadTheSearch(String name, double asked) {
        assertNotMisled(name, asked, asked / 4, 2);
    }

    @ParameterizedTest
    @Tag("full")
    @CsvSource({"cylinders, 0.01", "cylinders, 0.005", "cone, 0.01", "cone, 0.005"})
    void norIsItMisledWhereLessErrorIsAskedFor(String name, double asked) {
        assertNotMisled(name, asked, asked / 10, 3);
    }

    /** @param of the error of the reference, which adds to what is measured: a large one is no help to pass */
    private static void assertNotMisled(String name, double asked, double of, int seeds) {
        Scene scene = ManySeeds.shipped(name);
        double[] truth = reference(scene, Method.CLUSTER, 200, 100, of);
        RenderSettings s =
                settings(scene, Method.CLUSTER, 200, 100).withBudget(RenderSettings.Budget.NONE.withError(asked));
        for (int seed = 0; seed < seeds; seed++) {
            RenderResult p = render(scene, s.withSeed(seed));
            double error = distance(p, truth);
            RenderReport.Sampling sampling = p.report().sampling();
            assertTrue(error <= asked, error + " with " + sampling);
            // The first number that is tried with a survey is 4: to plan for fewer would cost more than it saves.
            assertTrue(sampling.samplesPerPixel() < 4.1, sampling.toString());
        }
    }

    @ParameterizedTest
    @Tag("full")
    @ClassicMethods
    void theErrorThatIsAskedForIsKeptAndNotFarUndercut(Method method) {
        int seeds = 20;
        List<String> failures = new ArrayList<>();
        for (String name : List.of("fire-and-ice", "cylinders", "cone", "glass", "keyhole", "torus")) {
            Scene scene = ManySeeds.shipped(name);
            double[] truth = reference(scene, method, 200, 100, 0.0005);
            for (double asked : new double[] {0.02, 0.01, 0.005}) {
                RenderSettings s =
                        settings(scene, method, 200, 100).withBudget(RenderSettings.Budget.NONE.withError(asked));
                List<Double> ratios = new ArrayList<>();
                int inside = 0;
                double samples = 0;
                int rounds = 0;
                for (int seed = 0; seed < seeds; seed++) {
                    RenderResult p = render(scene, s.withSeed(seed));
                    RenderReport.Sampling sampling = p.report().sampling();
                    double error = distance(p, truth);
                    ratios.add(error / asked);
                    samples += sampling.plannedSamples();
                    rounds += sampling.rounds();
                    inside += error >= sampling.errorLow() && error <= sampling.errorHigh() ? 1 : 0;
                }
                Collections.sort(ratios);
                double median = (ratios.get(seeds / 2) + ratios.get(seeds / 2 - 1)) / 2;
                long kept = ratios.stream().filter(r -> r <= 1).count();
                String line = String.format(
                        "%-9s %-13s error %.3f: kept %2d of %d, median %.2f, most %.2f, in the interval %d, rounds %.2f, samples %.2f",
                        method,
                        name,
                        asked,
                        kept,
                        seeds,
                        median,
                        ratios.get(seeds - 1),
                        inside,
                        (double) rounds / seeds,
                        samples / seeds);
                System.out.println(line);
                // Where evenly spaced rays are not exact enough and the fewest that surveys take are far more
                // exact, there is nothing between them, and less would not be quicker.
                boolean fewest = method == Method.CLUSTER && samples / seeds < 2.5;
                // An interval whose upper end is as asked has its middle a seventh or more below.
                if (kept < 0.95 * seeds || median < 0.5 && !fewest) {
                    failures.add(line);
                }
            }
        }
        assertTrue(failures.isEmpty(), String.join("\n", failures));
    }

    private static void assertReplayed(Method method, int width, int height, List<RenderSettings.Budget> budgets) {
        Scene scene = ManySeeds.shipped("keyhole");
        for (RenderSettings.Budget budget : budgets) {
            RenderSettings s = settings(scene, method, width, height).withBudget(budget);
            RenderResult planned = render(scene, s);
            double samples = planned.report().sampling().plannedSamples();
            RenderResult again = render(scene, s.withBudget(budget.replayable(samples)));
            assertArrayEquals(planned.image().toArray(), again.image().toArray(), method + " with " + budget);
            assertEquals(planned.report().raysByKind(), again.report().raysByKind());
        }
    }

    /** Of each method one plan for an error and one for a time, and one for a number that decides before the error. */
    @Test
    void whatWasPlannedMakesTheSamePictureAsANumberOfSamples() {
        assertReplayed(
                Method.RAYTRACE,
                32,
                16,
                List.of(RenderSettings.Budget.NONE.withError(0.04), RenderSettings.Budget.NONE.withSeconds(0.05)));
        assertReplayed(
                Method.CLUSTER,
                32,
                16,
                List.of(
                        RenderSettings.Budget.NONE.withError(0.04).withSeconds(5),
                        RenderSettings.Budget.NONE.withSeconds(0.05),
                        RenderSettings.Budget.NONE.withError(1e-5).withSamples(12.341)));
    }

    @ParameterizedTest
    @Tag("full")
    @ClassicMethods
    void soItDoesWithMoreBudgets(Method method) {
        assertReplayed(
                method,
                64,
                32,
                List.of(
                        RenderSettings.Budget.NONE.withError(0.02),
                        RenderSettings.Budget.NONE.withSeconds(0.3),
                        RenderSettings.Budget.NONE.withError(0.02).withSamples(5.5),
                        RenderSettings.Budget.NONE.withError(1e-5).withSamples(12.341),
                        RenderSettings.Budget.NONE.withError(0.04).withSeconds(5)));
    }

    @ParameterizedTest
    @ValueSource(doubles = {1, 12.341})
    void aNumberOfSamplesIsDecisiveWhereTheErrorCannotBeReached(double samples) {
        Scene scene = ManySeeds.shipped("fire-and-ice");
        for (Method method : BuiltInMethod.rendering(Shading.Model.CLASSIC)) {
            RenderSettings s = settings(scene, method, 32, 16)
                    .withBudget(RenderSettings.Budget.NONE.withError(1e-7).withSamples(samples));
            RenderReport p = render(scene, s).report();
            assertEquals("samples", p.sampling().decidedBy(), method.word());
            assertEquals(samples, p.sampling().plannedSamples(), method.word());
            assertFalse(p.isErrorMet());
        }
    }

    @ParameterizedTest
    @Tag("full")
    @ValueSource(doubles = {12.36, 40})
    void soAreOtherNumbersOfSamples(double samples) {
        aNumberOfSamplesIsDecisiveWhereTheErrorCannotBeReached(samples);
    }

    /** What a survey takes would be missing elsewhere: no method may lose to its own rays, evenly spaced. */
    @Test
    void withTooFewSamplesForASurveyTheClusterMethodIsTheRayTracerToTheLastBit() {
        assertSurveyedFrom245("keyhole", 1, 2.44, 2.45);
    }

    @ParameterizedTest
    @Tag("full")
    @ValueSource(strings = {"fire-and-ice", "keyhole"})
    void soItIsInMoreScenes(String name) {
        assertSurveyedFrom245(name, 1, 1.7, 2.44, 2.45, 4);
    }

    private static void assertSurveyedFrom245(String name, double... numbers) {
        Scene scene = ManySeeds.shipped(name);
        for (double samples : numbers) {
            RenderSettings.Budget budget = RenderSettings.Budget.NONE.withSamples(samples);
            Picture cluster = ManySeeds.render(
                    scene, settings(scene, Method.CLUSTER, 64, 32).withBudget(budget));
            Picture raytrace = ManySeeds.render(
                    scene, settings(scene, Method.RAYTRACE, 64, 32).withBudget(budget));
            assertEquals(
                    samples < 2.45 ? Method.RAYTRACE : Method.CLUSTER,
                    cluster.sampling().method());
            assertEquals(samples < 2.45, Arrays.equals(raytrace.rgb(), cluster.rgb()), samples + " samples");
        }
    }

    @ParameterizedTest
    @Tag("full")
    @CsvSource({"fire-and-ice, CLUSTER", "cylinders, CLUSTER", "glass, CLUSTER", "keyhole, CLUSTER", "keyhole, RAYTRACE"
    })
    void norIsTheTrueErrorAboveWhatWasAskedInLargerPictures(String name, BuiltInMethod method) {
        assertBelow(name, method, 72, 36);
    }

    @Test
    void anErrorThatIsReachedAtOnceTakesTheFewestSamples() {
        Scene scene = ManySeeds.shipped("fire-and-ice");
        for (Method method : BuiltInMethod.rendering(Shading.Model.CLASSIC)) {
            RenderSettings s = settings(scene, method, 64, 32).withBudget(RenderSettings.Budget.NONE.withError(0.9));
            Picture p = ManySeeds.render(scene, s);
            assertEquals("error", p.sampling().decidedBy(), method.word());
            assertTrue(Arrays.stream(p.counts()).allMatch(n -> n == 1), method.word());
        }
    }

    /** What is asked for is what the report shows was spent, whoever decided about it. */
    @ParameterizedTest
    @ValueSource(doubles = {1.37, 2.5, 12.3})
    void raytraceTakesTheSamplesThatItMayTake(double samples) {
        Scene scene = ManySeeds.shipped("fire-and-ice");
        RenderSettings s = settings(scene, Method.RAYTRACE, 96, 48).with(new BuiltInMethod.RayTraceSettings(1));
        for (RenderSettings settings : List.of(s, s.withCrop(new RenderSettings.Crop(13, 5, 61, 33)))) {
            RenderReport report = render(scene, settings.withBudget(RenderSettings.Budget.NONE.withSamples(samples)))
                    .report();
            assertEquals(samples, report.sampling().plannedSamples());
            // The share of doubled pixels is met within a few pixels.
            assertEquals(1, report.sampling().samplesPerPixel() / samples, 0.01);
            double camera = report.raysByKind().get("camera");
            assertEquals(report.sampling().samplesPerPixel(), camera / report.pixels(), 1e-9);
        }
    }

    @ParameterizedTest
    @Tag("full")
    @ValueSource(doubles = {1, 2.44, 5, 48})
    void norDoesRaytraceTakeMoreOrLessOfOtherNumbers(double samples) {
        raytraceTakesTheSamplesThatItMayTake(samples);
    }

    @Test
    void whatIsPlannedForAnErrorOrATimeIsSpent() {
        Scene scene = ManySeeds.shipped("glass");
        for (RenderSettings.Budget budget :
                List.of(RenderSettings.Budget.NONE.withError(0.02), RenderSettings.Budget.NONE.withSeconds(0.15))) {
            RenderReport.Sampling sampling = render(
                            scene, settings(scene, Method.RAYTRACE, 160, 80).withBudget(budget))
                    .report()
                    .sampling();
            assertEquals(1, sampling.samplesPerPixel() / sampling.plannedSamples(), 0.01);
        }
    }

    @ParameterizedTest
    @CsvSource({"fire-and-ice, 4", "keyhole, 30"})
    void clusterTakesAboutTheSamplesThatItMayTake(String name, double samples) {
        Scene scene = ManySeeds.shipped(name);
        RenderSettings s =
                settings(scene, Method.CLUSTER, 96, 48).withBudget(RenderSettings.Budget.NONE.withSamples(samples));
        double taken = ManySeeds.render(scene, s).sampling().samplesPerPixel();
        // All 72 blocks were surveyed to plan it, but with other samples; and where clusters learn they take more
        // survey
        // rays than was planned.
        double chance = name.equals("fire-and-ice") ? 0.03 : 0.1;
        assertEquals(1, taken / samples, chance, name + ": " + taken + " for " + samples);
    }

    @ParameterizedTest
    @Tag("full")
    @CsvSource({"fire-and-ice, 30", "keyhole, 4", "glass, 4", "glass, 30"})
    void soItDoesInMoreScenes(String name, double samples) {
        clusterTakesAboutTheSamplesThatItMayTake(name, samples);
    }
}
