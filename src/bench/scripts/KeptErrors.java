import com.sun.management.OperatingSystemMXBean;
import enlightenment.image.Image;
import enlightenment.render.RenderProgress;
import enlightenment.render.RenderResult;
import enlightenment.render.Renderer;
import enlightenment.report.RenderReport;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.json.SceneReader;
import java.lang.management.ManagementFactory;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/**
 * How often an error that is asked for is kept:
 *
 * <pre>
 * java -cp target/enlightenment.jar src/bench/scripts/KeptErrors.java WxH SEEDS SECONDS ERROR[,ERROR...] SCENE...
 * </pre>
 *
 * Every scene is rendered by {@code -Dmethods=raytrace,cluster} with seeds 1 to SEEDS and each error; a row that has taken SECONDS of
 * processor time gets no more seeds. After each seed a picture by raytrace with another seed and at least {@code -Dreference=256} samples
 * joins the scene's reference, until these have taken {@code -DreferenceSeconds}. What is true is the difference, as shown, from the mean
 * of those, less what that mean itself errs by. The table is printed after each seed.
 */
public final class KeptErrors {
    private static final int LEAST_REFERENCE = Integer.getInteger("reference", 256);

    /** A scene whose references have taken this processor time, in seconds, gets no more of them; by default as rows. */
    private static final String REFERENCE_SECONDS = System.getProperty("referenceSeconds");

    private static final String METHODS = System.getProperty("methods", "raytrace,cluster");

    private static final OperatingSystemMXBean MACHINE =
            (OperatingSystemMXBean) ManagementFactory.getOperatingSystemMXBean();

    private static final class Row {
        final String name;
        final BuiltInMethod method;
        final double asked;
        final List<RenderResult> results = new ArrayList<>();
        double seconds;

        Row(String name, BuiltInMethod method, double asked) {
            this.name = name;
            this.method = method;
            this.asked = asked;
        }
    }

    /** The mean of pictures with the same number of samples. */
    private static final class Reference {
        double samples;
        int pictures;
        double[] sum;
        double[] squares;
        double seconds;

        void add(Image image) {
            float[] rgb = image.toArray();
            sum = sum == null ? new double[rgb.length] : sum;
            squares = squares == null ? new double[rgb.length] : squares;
            pictures++;
            for (int i = 0; i < rgb.length; i++) {
                sum[i] += rgb[i];
                squares[i] += (double) rgb[i] * rgb[i];
            }
        }

        /** The displayed error of a picture, root mean square. */
        double error(Image image) {
            float[] rgb = image.toArray();
            double difference = 0;
            double own = 0;
            for (int i = 0; i < rgb.length; i++) {
                double mean = sum[i] / pictures;
                double variance = Math.max(squares[i] / pictures - mean * mean, 0) / Math.max(pictures - 1, 1);
                double d = image.curve().of(rgb[i]) - image.curve().of(mean);
                double deviation = Math.sqrt(variance);
                double e = image.curve().of(mean + deviation) - image.curve().of(Math.max(mean - deviation, 0));
                difference += d * d;
                own += e * e / 4;
            }
            return Math.sqrt(Math.max(difference - own, 0) / rgb.length);
        }
    }

    private KeptErrors() {}

    public static void main(String[] arguments) throws Exception {
        String[] size = arguments[0].split("x");
        int seeds = Integer.parseInt(arguments[1]);
        double cap = Double.parseDouble(arguments[2]);
        double referenceCap = REFERENCE_SECONDS == null ? cap : Double.parseDouble(REFERENCE_SECONDS);
        Map<String, Scene> scenes = new LinkedHashMap<>();
        Map<String, Reference> references = new LinkedHashMap<>();
        for (int i = 4; i < arguments.length; i++) {
            String name = Path.of(arguments[i]).getFileName().toString().replace(".json", "");
            scenes.put(name, SceneReader.read(Path.of(arguments[i])));
            references.put(name, new Reference());
        }
        List<Row> rows = new ArrayList<>();
        for (String error : arguments[3].split(",")) {
            for (String name : scenes.keySet()) {
                for (String method : METHODS.split(",")) {
                    rows.add(new Row(
                            name, BuiltInMethod.valueOf(method.toUpperCase(Locale.ROOT)), Double.parseDouble(error)));
                }
            }
        }
        for (int seed = 1; seed <= seeds; seed++) {
            for (Row row : rows) {
                if (row.seconds >= cap) {
                    continue;
                }
                RenderSettings settings = RenderSettings.of(scenes.get(row.name))
                        .withSize(Integer.parseInt(size[0]), Integer.parseInt(size[1]))
                        .withMethod(row.method);
                long before = MACHINE.getProcessCpuTime();
                row.results.add(render(
                        scenes.get(row.name),
                        settings.withBudget(RenderSettings.Budget.NONE.withError(row.asked)),
                        seed));
                row.seconds += (MACHINE.getProcessCpuTime() - before) / 1e9;
                Reference reference = references.get(row.name);
                if (row.method == rows.get(0).method && reference.seconds < referenceCap) {
                    if (reference.samples == 0) {
                        reference.samples = Math.max(
                                LEAST_REFERENCE,
                                Math.ceil(row.results.get(0).report().sampling().plannedSamples()));
                    }
                    before = MACHINE.getProcessCpuTime();
                    reference.add(render(
                                    scenes.get(row.name),
                                    settings.withMethod(BuiltInMethod.RAYTRACE)
                                            .withBudget(RenderSettings.Budget.NONE.withSamples(reference.samples)),
                                    1_000_000L + 1000 * reference.pictures)
                            .image());
                    reference.seconds += (MACHINE.getProcessCpuTime() - before) / 1e9;
                    System.err.printf(
                            "%d %s %s %.1f %.1f%n", seed, row.name, row.asked, row.seconds, reference.seconds);
                }
            }
            print(rows, references);
        }
    }

    private static RenderResult render(Scene scene, RenderSettings settings, long seed) {
        return Renderer.render(scene, settings.withSeed(seed), RenderProgress.NONE, () -> false);
    }

    private static void print(List<Row> rows, Map<String, Reference> references) {
        System.out.println(
                "| scene | method | error | kept | not, and told | true error: least, median, most | in the interval | warned | samples per pixel"
                        + " (median) | rounds | CPU-s per picture |");
        System.out.println("|---|---|---|---|---|---|---|---|---|---|---|");
        for (Row row : rows) {
            Reference reference = references.get(row.name);
            int n = row.results.size();
            if (reference.pictures < 2) {
                continue;
            }
            double[] errors = new double[n];
            double[] samples = new double[n];
            double rounds = 0;
            int kept = 0;
            int told = 0;
            int inside = 0;
            int warned = 0;
            for (int i = 0; i < n; i++) {
                RenderResult result = row.results.get(i);
                RenderReport.Sampling s = result.report().sampling();
                double e = reference.error(result.image());
                errors[i] = e;
                samples[i] = s.samplesPerPixel();
                kept += e <= row.asked ? 1 : 0;
                told += e > row.asked && !result.report().isErrorMet() ? 1 : 0;
                inside += e >= s.errorLow() && e <= s.errorHigh() ? 1 : 0;
                warned += s.light().orElseThrow().heavyTail() ? 1 : 0;
                rounds += s.rounds();
            }
            java.util.Arrays.sort(errors);
            java.util.Arrays.sort(samples);
            System.out.printf(
                    Locale.ROOT,
                    "| %s | %s | %s | %d of %d | %d | %.4f, %.4f, %.4f | %d | %d | %.0f | %.1f | %.1f |%n",
                    row.name,
                    row.method.name().toLowerCase(Locale.ROOT),
                    row.asked,
                    kept,
                    n,
                    told,
                    errors[0],
                    errors[n / 2],
                    errors[n - 1],
                    inside,
                    warned,
                    samples[n / 2],
                    rounds / n,
                    row.seconds / n);
        }
        references.forEach((name, reference) -> System.out.printf(
                Locale.ROOT,
                "%s: %d references of %.0f samples per pixel%n",
                name,
                reference.pictures,
                reference.samples));
        System.out.flush();
    }
}
