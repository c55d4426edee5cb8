package enlightenment.measure.analysis;

import enlightenment.image.Image;
import enlightenment.image.ImageFiles;
import enlightenment.measure.trade.TradeResult;
import enlightenment.measure.trade.TradeRun;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.ToDoubleFunction;

/**
 * One picture by each method, rendered in equal time as far as such budgets were found; see {@link #isEqual}.
 *
 * @param pictures pictures in the order of the methods; empty if there was no time for them
 * @param referenceVariance the reference's own mean squared error
 * @param blind words of methods that do not sample all light of the scene, which are not compared
 */
public record EqualTimeComparison(List<EqualTimePicture> pictures, double referenceVariance, Set<String> blind) {
    /** Largest ratio of times that count as equal. */
    public static final double TOLERANCE = 1.1;

    /** Least ratio of two errors that count as different. */
    private static final double ALIKE = 1.02;

    /** Approximate error that differences are amplified to, by at most {@link #MAX_GAIN}. */
    private static final double CLEAR = 0.2;

    private static final int MAX_GAIN = 256;

    public EqualTimeComparison {
        pictures = List.copyOf(pictures);
        blind = Set.copyOf(blind);
    }

    /** Reads the last comparison of a result, with its pictures as far as they are in the folder. */
    public static EqualTimeComparison read(Path folder, TradeResult result) throws IOException {
        double variance = result.reference().variance();
        List<TradeRun> runs = new ArrayList<>();
        for (String method : result.settings().methods()) {
            result.runs().stream()
                    .filter(r ->
                            r.kind().equals(TradeRun.EQUAL_TIME) && r.method().equals(method))
                    .reduce((a, b) -> b)
                    .ifPresent(runs::add);
        }
        List<EqualTimePicture> pictures = new ArrayList<>();
        for (TradeRun run : runs) {
            pictures.add(new EqualTimePicture(
                    run,
                    image(folder.resolve(pictureName(run.method()))),
                    image(folder.resolve(differenceName(run.method()))),
                    gain(runs, variance)));
        }
        return new EqualTimeComparison(pictures, variance, result.blindSpots().keySet());
    }

    private static Optional<Image> image(Path file) throws IOException {
        return Files.exists(file) ? Optional.of(ImageFiles.read(file)) : Optional.empty();
    }

    /** The name of the file of a method's picture. */
    public static String pictureName(String method) {
        return "equal-time-" + method + ".png";
    }

    /** The name of the file of a picture's difference from the reference. */
    public static String differenceName(String method) {
        return "equal-time-" + method + "-error.png";
    }

    /** The name of the file of a picture's FLIP map. */
    public static String flipName(String method) {
        return "equal-time-" + method + "-flip.png";
    }

    /** The gain of the differences of runs: a power of two that lifts the largest error to about {@link #CLEAR}. */
    public static int gain(List<TradeRun> runs, double referenceVariance) {
        double error =
                runs.stream().mapToDouble(r -> r.error(referenceVariance)).max().orElse(1);
        int gain = 1;
        while (2 * gain * error <= CLEAR && gain < MAX_GAIN) {
            gain *= 2;
        }
        return gain;
    }

    /** Whether the times differ by at most {@link #TOLERANCE}; also true without pictures. */
    public boolean isEqual() {
        double longest =
                pictures.stream().mapToDouble(p -> p.run().wallSeconds()).max().orElse(1);
        double shortest =
                pictures.stream().mapToDouble(p -> p.run().wallSeconds()).min().orElse(1);
        return longest / shortest <= TOLERANCE;
    }

    /** The method closest to the reference, with the times, in one sentence; empty for fewer than two pictures. */
    public Optional<String> sentence() {
        if (pictures.size() < 2) {
            return Optional.empty();
        }
        String times = String.join(
                ", ",
                pictures.stream()
                        .map(p -> name(p) + " " + Digits.of(p.run().wallSeconds(), 2) + " s")
                        .toList());
        List<EqualTimePicture> compared =
                pictures.stream().filter(p -> !blind.contains(p.run().method())).toList();
        if (!isEqual() || compared.size() < 2) {
            return Optional.of("These pictures are " + (isEqual() ? "" : "not ") + "at equal time: " + times + ".");
        }
        return Optional.of("At equal time (" + times + ") " + verdict(compared)
                + (compared.size() < pictures.size() ? ", of those that see all of the scene" : "") + ".");
    }

    private String verdict(List<EqualTimePicture> compared) {
        Optional<String> rmse = better(compared, p -> p.run().error(referenceVariance));
        Optional<String> flip = better(compared, p -> p.run().flip());
        boolean two = compared.size() == 2;
        String nearest = two ? " is nearer to the truth" : " is nearest to the truth";
        if (rmse.isEmpty() || flip.isEmpty()) {
            return rmse.map(m -> "by RMSE " + m + nearest + ", FLIP sees no difference")
                    .or(() -> flip.map(m -> "by FLIP " + m + nearest + ", RMSE sees no difference"))
                    .orElse((two ? "neither" : "no single one") + nearest + ", by RMSE and by FLIP");
        }
        return rmse.equals(flip)
                ? rmse.get() + nearest + ", by RMSE and by FLIP"
                : "the two measures disagree: by RMSE " + rmse.get() + nearest + ", by FLIP " + flip.get();
    }

    /** The method of the picture with the smallest value, if all others are clearly larger. */
    private static Optional<String> better(List<EqualTimePicture> all, ToDoubleFunction<EqualTimePicture> value) {
        List<EqualTimePicture> sorted =
                all.stream().sorted(Comparator.comparingDouble(value)).toList();
        boolean clear = value.applyAsDouble(sorted.get(1)) > ALIKE * value.applyAsDouble(sorted.get(0));
        return clear ? Optional.of(name(sorted.get(0))) : Optional.empty();
    }

    private static String name(EqualTimePicture picture) {
        return Configuration.of(picture.run()).name();
    }
}
