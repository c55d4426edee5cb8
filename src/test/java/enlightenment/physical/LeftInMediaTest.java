package enlightenment.physical;

import static enlightenment.physical.PhysicalScenes.at;
import static enlightenment.physical.PhysicalScenes.ball;
import static enlightenment.physical.PhysicalScenes.matte;
import static enlightenment.physical.PhysicalScenes.shading;
import static enlightenment.physical.PhysicalScenes.view;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.color.Rgb;
import enlightenment.color.TransferCurve;
import enlightenment.image.Image;
import enlightenment.light.Emission;
import enlightenment.light.Light;
import enlightenment.material.Material;
import enlightenment.material.Medium;
import enlightenment.render.RenderProgress;
import enlightenment.render.RenderResult;
import enlightenment.render.Renderer;
import enlightenment.render.TestScenes;
import enlightenment.report.RenderReport;
import enlightenment.scene.Budget;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.SceneBuilder;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Supplier;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Bodies of wax and milk under small lamps, whose light paths from the eye find by chance only. What is true is told by the same picture
 * under a lamp of the same power that is twenty times as large, which lights the body in nearly the same way.
 */
class LeftInMediaTest {
    private static final double LARGE = 0.4;
    private static final Medium WAX = new Medium.Coefficients(new Rgb(8, 7, 5), new Rgb(0.05, 0.1, 0.4), 0);
    private static final Medium MILK = new Medium.Coefficients(Rgb.gray(25), Rgb.gray(0.05), 0.5);
    private static final Medium THIN = new Medium.Coefficients(new Rgb(1, 0.7, 0.3), Rgb.gray(0.05), 0);
    private static final Medium BLACK = new Medium.Coefficients(Rgb.gray(0x1p-20), Rgb.gray(0x1p10), 0);
    private static final Material GLASS = Material.Glass.of(PhysicalScenes.linear(1, 1, 1), 1.5);

    private static final Map<String, RenderResult> TRUTHS = new ConcurrentHashMap<>();

    /** A lamp of the power 60 over the scene, on the side of the eye; without extent it is a point. */
    private static Light lamp(double radius) {
        Rgb power = Rgb.gray(60);
        return radius > 0
                ? new Light.Sphere(at(-1.2, 3, -1.5), radius, Rgb.WHITE, Emission.power(power))
                : new Light.Point(at(-1.2, 3, -1.5), Rgb.WHITE, Emission.intensity(Rgb.gray(60 / (4 * Math.PI))));
    }

    private static SceneBuilder floor(double background) {
        return view(14, 12)
                .shading(shading(background))
                .object(
                        TestScenes.rectangle(-4, -0.1, -4, -4, -0.1, 4, 4, -0.1, 4, 4, -0.1, -4),
                        matte(0.4, 0.35, 0.3));
    }

    private static Material solid(Medium medium, double index) {
        return new Material.Scattering(medium, index, 0, 1);
    }

    private static SceneBuilder body(String name) {
        return switch (name) {
            case "wax" -> floor(0.02).object(ball(0, 0.9, 0, 0.8), solid(WAX, 1.4));
            case "milk" -> floor(0.02).object(ball(0, 0.9, 0, 0.8), solid(MILK, 1.33));
            case "juice" -> floor(0.02).object(ball(0, 0.9, 0, 0.8), solid(THIN, 1.5));
            case "black" -> floor(0.02).object(ball(0, 0.9, 0, 0.8), solid(BLACK, 1.5));
            case "sky" -> floor(0.3).object(ball(0, 0.9, 0, 0.8), solid(WAX, 1.4));
            case "glass" ->
                floor(0.02).object(ball(0, 0.9, 0, 0.9), GLASS).object(ball(0, 0.9, 0, 0.75), solid(MILK, 1.35));
            default -> throw new IllegalArgumentException(name);
        };
    }

    private static RenderResult render(SceneBuilder scene, BuiltInMethod method, double samples) {
        Scene made = scene.build();
        RenderSettings settings =
                RenderSettings.of(made).withMethod(method).withThreads(2).withBudget(Budget.NONE.withSamples(samples));
        return Renderer.render(made, settings, RenderProgress.NONE, () -> false);
    }

    private static RenderResult truth(String name) {
        return TRUTHS.computeIfAbsent(name, n -> render(body(n).light(lamp(LARGE)), BuiltInMethod.RAYTRACE, 1500));
    }

    private static double shown(double light) {
        return TransferCurve.encode(Math.min(light, 1));
    }

    private static double difference(RenderResult one, RenderResult other) {
        float[] a = one.image().toArray();
        float[] b = other.image().toArray();
        double sum = 0;
        for (int i = 0; i < a.length; i++) {
            double d = shown(a[i]) - shown(b[i]);
            sum += d * d;
        }
        return Math.sqrt(sum / a.length);
    }

    private static double leftToChance(RenderResult result) {
        return result.report().sampling().light().orElseThrow().leftToChance();
    }

    /** The light of a lamp of this size is found by no path, or by one in some tens of thousands. */
    @ParameterizedTest
    @CsvSource({"wax, 0.02", "wax, 0", "milk, 0.02", "juice, 0.02", "juice, 0", "sky, 0.02", "glass, 0", "glass, 0.02"})
    void whatAPictureLacksIsInItsEstimatedError(String name, double radius) {
        RenderResult truth = truth(name);
        RenderResult lacking = render(body(name).light(lamp(radius)), BuiltInMethod.RAYTRACE, 16);
        double told = lacking.report().sampling().estimatedError();
        double real = difference(truth, lacking);
        assertTrue(real > 0.04, "too little is lacking to tell: " + real);
        assertTrue(told > 0.7 * real && told < 1.5 * real, told + " is told of " + real);
        assertTrue(leftToChance(lacking) > 0.5 * told, "of another reason");
    }

    @ParameterizedTest
    @EnumSource(names = {"CLUSTER", "METROPOLIS"})
    void soItIsByOtherMethodsWhosePathsComeFromTheEye(BuiltInMethod method) {
        RenderResult truth = truth("wax");
        RenderResult lacking = render(body("wax").light(lamp(0)), method, 16);
        double told = lacking.report().sampling().estimatedError();
        double real = difference(truth, lacking);
        assertTrue(told > 0.7 * real && told < 1.5 * real, told + " is told of " + real);
    }

    /** One path from the lamp of some fifty comes into the body, and of those most are far from where the path from the eye is. */
    @ParameterizedTest
    @CsvSource({"wax, 0.02", "wax, 0", "milk, 0.02", "milk, 0", "juice, 0.02", "sky, 0", "glass, 0.02"})
    void whatFewSamplesOfPathsFromBothEndsLackIsInTheirEstimatedError(String name, double radius) {
        RenderResult truth = truth(name);
        for (int samples : new int[] {4, 16}) {
            RenderResult lacking = render(body(name).light(lamp(radius)), BuiltInMethod.BIDIRECTIONAL, samples);
            double told = lacking.report().sampling().estimatedError();
            double real = difference(truth, lacking);
            assertTrue(told > 0.75 * real && told < 1.5 * real, told + " is told of " + real);
        }
    }

    /**
     * Paths from the two ends do not meet where light of a point is scattered once between two borders: no number of samples finds it.
     * Of a black body there is only what its border reflects, which of a point cannot be seen.
     */
    @Test
    void lightThatIsScatteredOnceIsLackingForEver() {
        RenderResult lacking = render(body("juice").light(lamp(0)), BuiltInMethod.BIDIRECTIONAL, 4096);
        float[] seen = lacking.image().toArray();
        float[] reflected = render(body("black").light(lamp(0)), BuiltInMethod.BIDIRECTIONAL, 256)
                .image()
                .toArray();
        float[] all = render(body("juice").light(lamp(LARGE)), BuiltInMethod.RAYTRACE, 16_000)
                .image()
                .toArray();
        float[] allReflected = truth("black").image().toArray();
        double sum = 0;
        for (int i = 0; i < seen.length; i++) {
            double light = reflected[i] + all[i] - allReflected[i];
            double d = shown(Math.max(light, 0)) - shown(seen[i]);
            sum += d * d;
        }
        double told = lacking.report().sampling().estimatedError();
        double real = Math.sqrt(sum / seen.length);
        assertTrue(leftToChance(lacking) > 0.5 * told, "of another reason");
    }

    @Test
    void pathsFromBothEndsAreToldToFindWhatLampsSendEverywhere() {
        assertEquals(0, leftToChance(render(body("sky"), BuiltInMethod.BIDIRECTIONAL, 4)));
        SceneBuilder open =
                floor(0.02).object(ball(0, 0.9, 0, 0.8), solid(WAX, 1)).light(lamp(0.02));
        assertEquals(0, leftToChance(render(open, BuiltInMethod.BIDIRECTIONAL, 4)));
        SceneBuilder large = body("wax").light(lamp(0.8));
        assertEquals(0, leftToChance(render(large, BuiltInMethod.BIDIRECTIONAL, 4)));
    }

    /** Samples tell all that there is to tell: of large lamps, of light from everywhere, and where lamps are sampled. */
    @Test
    void whatManyPathsFindIsNotToldTwice() {
        SceneBuilder even = body("sky");
        SceneBuilder large = body("wax").light(lamp(LARGE));
        SceneBuilder rough = floor(0.02)
                .object(ball(0, 0.9, 0, 0.8), new Material.Scattering(WAX, 1.4, 0.3, 0))
                .light(lamp(0.02));
        SceneBuilder open =
                floor(0.02).object(ball(0, 0.9, 0, 0.8), solid(WAX, 1)).light(lamp(0.02));
        for (SceneBuilder scene : List.of(even, large, rough, open)) {
            RenderResult result = render(scene, BuiltInMethod.RAYTRACE, 64);
            assertTrue(leftToChance(result) < 0.15 * result.report().sampling().estimatedError());
        }
    }

    /** An error that no number of samples mends is given up as soon as the rest of it is as asked. */
    @ParameterizedTest
    @ValueSource(doubles = {0.05, 0.03})
    void anErrorIsNotCalledMetWithoutThatLight(double asked) {
        Scene scene = body("wax").light(lamp(0)).build();
        List<String> notes = new ArrayList<>();
        RenderProgress heard = new RenderProgress() {
            @Override
            public void progress(long done, long all, Supplier<Image> soFar) {}

            @Override
            public void note(String note) {
                notes.add(note);
            }
        };
        RenderSettings settings = RenderSettings.of(scene).withThreads(2).withBudget(Budget.NONE.withError(asked));
        RenderResult result = Renderer.render(scene, settings, heard, () -> false);
        RenderReport report = result.report();
        assertFalse(report.isErrorMet());
        assertTrue(report.sampling().plannedSamples() < 500, "went on with " + report.sampling());
        assertEquals(OptionalDouble.empty(), result.samplesForError());
        assertTrue(notes.stream().anyMatch(n -> n.contains("try --method bidirectional")), notes::toString);
    }
}
