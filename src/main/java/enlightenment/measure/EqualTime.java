package enlightenment.measure;

import enlightenment.image.Flip;
import enlightenment.image.Image;
import enlightenment.image.ImageFiles;
import enlightenment.picture.HeatMap;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.ToDoubleFunction;

/**
 * A picture that took as long as those of the other methods, as far as such budgets were found: {@link #areEqual} tells.
 *
 * @param run how it was made and what it is worth
 * @param image the picture; nothing where it was not kept
 * @param difference by how much each number of it differs from the reference, times {@code gain}; nothing where it was not kept
 * @param gain what makes the differences visible; the same for all methods
 */
public record EqualTime(TradeRun run, Optional<Image> image, Optional<Image> difference, int gain) {
    /** An error that can be seen. */
    private static final double VISIBLE = 0.02;

    private static final double CLEAR = 0.2;
    private static final int MOST_GAIN = 256;
    private static final double STARTS = 1.5;

    /** Up to this share of the budget another round may begin, without sweeps and with. */
    private static final double SHARE = 0.95;

    private static final double SHARE_WITH_SWEEPS = 0.7;

    /** A difference of two errors that is smaller than this share of them decides nothing. */
    private static final double ALIKE = 1.02;

    /** Whether the times differ so little that they may be called equal: by a tenth at most. */
    public static boolean areEqual(List<EqualTime> pictures) {
        double[] seconds =
                pictures.stream().mapToDouble(e -> e.run.wallSeconds()).toArray();
        return new EqualTimeSearch.Found(new double[seconds.length], seconds).isEqual();
    }

    /** What the pictures say of the methods, with their times: one sentence, or nothing if there are fewer than two. */
    public static Optional<String> sentence(List<EqualTime> pictures, double referenceVariance) {
        if (pictures.size() < 2) {
            return Optional.empty();
        }
        StringBuilder text = new StringBuilder();
        for (EqualTime e : pictures) {
            text.append(text.isEmpty() ? "" : ", ")
                    .append(Contender.of(e.run).name())
                    .append(" ");
            text.append(Digits.of(e.run.wallSeconds(), 2)).append(" s");
        }
        if (!areEqual(pictures)) {
            return Optional.of("These pictures are not at equal time: " + text + ".");
        }
        Optional<String> rmse = better(pictures, e -> e.run.error(referenceVariance));
        Optional<String> flip = better(pictures, e -> e.run.flip());
        String verdict = "At equal time (" + text + ") ";
        if (rmse.isEmpty() || flip.isEmpty()) {
            String nearer = rmse.map(m -> "by RMSE " + m + " is nearer to the truth, FLIP sees no difference")
                    .or(() -> flip.map(m -> "by FLIP " + m + " is nearer to the truth, RMSE sees no difference"))
                    .orElse("neither is nearer to the truth, by RMSE and by FLIP");
            return Optional.of(verdict + nearer + ".");
        }
        return Optional.of(verdict
                + (rmse.equals(flip)
                        ? rmse.get() + " is nearer to the truth, by RMSE and by FLIP."
                        : "the two measures disagree: by RMSE " + rmse.get() + " is nearer to the truth, by FLIP "
                                + flip.get() + "."));
    }

    /** The one with the smallest value, if all others are clearly larger. */
    private static Optional<String> better(List<EqualTime> pictures, ToDoubleFunction<EqualTime> value) {
        List<EqualTime> sorted =
                pictures.stream().sorted(Comparator.comparingDouble(value)).toList();
        boolean clear = value.applyAsDouble(sorted.get(1)) > ALIKE * value.applyAsDouble(sorted.get(0));
        return clear ? Optional.of(Contender.of(sorted.get(0).run).name()) : Optional.empty();
    }

    /** One picture for each method, written into the folder as well; each method with what is its best for a visible error. */
    static List<EqualTime> make(Session session) throws IOException {
        List<Reach> best = new ArrayList<>();
        for (String method : session.settings.methods()) {
            List<Reach> all = session.reaches(method).stream()
                    .filter(r -> !r.contender().grid())
                    .toList();
            Contender contender =
                    TradeResult.quickest(all, VISIBLE).map(Need::contender).orElse(session.settings.own(method));
            best.add(session.reach(contender));
        }
        if (best.stream().anyMatch(r -> r.points().isEmpty())) {
            return List.of();
        }
        session.say("pictures at equal time");
        double seconds = seconds(best);
        double[] start = best.stream()
                .mapToDouble(r -> Digits.nearTwo(r.samplesIn(seconds)))
                .toArray();
        long seed = session.settings.base().seed();
        Map<String, Meter.Timed> renders = new HashMap<>();
        double share = session.settings.sweeps().isEmpty() ? SHARE : SHARE_WITH_SWEEPS;
        EqualTimeSearch search = new EqualTimeSearch(
                (i, samples) -> {
                    Meter.Timed t = session.timed(best.get(i).contender(), samples, seed);
                    renders.put(i + " " + samples, t);
                    return t.wall();
                },
                () -> session.fits(4 * seconds, share));
        EqualTimeSearch.Found found = search.search(start);
        List<Meter.Timed> chosen = new ArrayList<>();
        for (int i = 0; i < start.length; i++) {
            Meter.Timed t = renders.get(i + " " + found.samples()[i]);
            chosen.add(new Meter.Timed(t.image(), t.settings(), found.seconds()[i], t.cpu(), t.sampling()));
        }
        return kept(session, chosen);
    }

    private static List<EqualTime> kept(Session session, List<Meter.Timed> renders) throws IOException {
        List<TradeRun> runs = session.record(TradeRun.EQUAL_TIME, renders);
        int gain = gain(runs, session.reference().variance());
        List<EqualTime> pictures = new ArrayList<>();
        for (int i = 0; i < runs.size(); i++) {
            Image image = renders.get(i).image();
            Image map =
                    HeatMap.withScale(Flip.between(image, session.reference().image()));
            String method = runs.get(i).method();
            ImageFiles.writePng(image, session.folder.file(name(method, "")));
            ImageFiles.writePng(map, session.folder.file(name(method, "-flip")));
            Image difference = difference(image, session.reference().image(), gain);
            ImageFiles.writePng(difference, session.folder.file(name(method, "-error")));
            pictures.add(new EqualTime(runs.get(i), Optional.of(image), Optional.of(difference), gain));
        }
        return pictures;
    }

    private static String name(String method, String what) {
        return "equal-time-" + method + what + ".png";
    }

    /** The pictures of an earlier time, as far as they were kept: the last run of each method. */
    static List<EqualTime> stored(List<String> methods, List<TradeRun> all, TradeFolder folder, double variance)
            throws IOException {
        List<TradeRun> runs = new ArrayList<>();
        for (String method : methods) {
            all.stream()
                    .filter(r ->
                            r.kind().equals(TradeRun.EQUAL_TIME) && r.method().equals(method))
                    .reduce((a, b) -> b)
                    .ifPresent(runs::add);
        }
        List<EqualTime> pictures = new ArrayList<>();
        for (TradeRun run : runs) {
            pictures.add(new EqualTime(
                    run,
                    read(folder.file(name(run.method(), ""))),
                    read(folder.file(name(run.method(), "-error"))),
                    gain(runs, variance)));
        }
        return pictures;
    }

    private static Optional<Image> read(Path file) throws IOException {
        return Files.exists(file) ? Optional.of(ImageFiles.read(file)) : Optional.empty();
    }

    /** A power of two that lifts the largest error to about a fifth of white. */
    private static int gain(List<TradeRun> runs, double variance) {
        double error = runs.stream().mapToDouble(r -> r.error(variance)).max().orElse(1);
        int gain = 1;
        while (2 * gain * error <= CLEAR && gain < MOST_GAIN) {
            gain *= 2;
        }
        return gain;
    }

    private static Image difference(Image a, Image b, int gain) {
        float[] rgb = a.toArray();
        float[] other = b.toArray();
        for (int i = 0; i < rgb.length; i++) {
            rgb[i] = Math.min(gain * Math.abs(rgb[i] - other[i]), 1);
        }
        return new Image(a.width(), a.height(), rgb);
    }

    /** The time in which the quickest method comes down to a visible error, but enough for each to do more than begin. */
    private static double seconds(List<Reach> reaches) {
        double visible = reaches.stream()
                .flatMap(r -> r.forError(VISIBLE).stream())
                .mapToDouble(n -> n.wall().median())
                .min()
                .orElse(0);
        double start = reaches.stream()
                .mapToDouble(r -> r.points().get(0).wall().low())
                .max()
                .orElse(0);
        return Math.max(visible, STARTS * start);
    }
}
