package enlightenment.measure;

import enlightenment.image.Image;
import enlightenment.image.ImageFiles;
import enlightenment.image.flip.Flip;
import enlightenment.measure.analysis.Configuration;
import enlightenment.measure.analysis.CostEstimate;
import enlightenment.measure.analysis.Digits;
import enlightenment.measure.analysis.EqualTimeComparison;
import enlightenment.measure.analysis.MeasuredCosts;
import enlightenment.measure.analysis.TradeAnalysis;
import enlightenment.measure.trade.TradeRun;
import enlightenment.picture.HeatMap;
import java.io.IOException;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * Renders one picture by each method in equal time. Picture and difference from the reference are files of the folder. Each method
 * uses its best configuration for a visible error.
 */
final class EqualTimeRenders {
    /** A visible root mean square error, in display units. */
    private static final double VISIBLE = 0.02;

    /** Least ratio of the equal time to the cheapest render of each method, so that fixed costs are not compared. */
    private static final double FIXED_COST = 1.5;

    /** The share of the budget up to which another round may begin, without sweeps and with. */
    private static final double SHARE = 0.95;

    private static final double SHARE_WITH_SWEEPS = 0.7;

    private final Session session;

    EqualTimeRenders(Session session) {
        this.session = session;
    }

    void run() throws IOException {
        List<MeasuredCosts> best = best();
        if (best.stream().anyMatch(r -> r.points().isEmpty())) {
            return;
        }
        session.say("pictures at equal time");
        double seconds = seconds(best);
        double[] start = best.stream()
                .mapToDouble(r -> Digits.nearTwo(r.samplesIn(seconds)))
                .toArray();
        long seed = session.settings.base().seed();
        Map<String, TimedRenderer.Timed> renders = new HashMap<>();
        double share = session.settings.sweeps().isEmpty() ? SHARE : SHARE_WITH_SWEEPS;
        EqualTimeSearch search = new EqualTimeSearch(
                (i, samples) -> {
                    TimedRenderer.Timed t = session.timed(best.get(i).configuration(), samples, seed);
                    renders.put(i + " " + samples, t);
                    return t.wall();
                },
                () -> session.fits(2 * best.size() * seconds, share));
        EqualTimeSearch.Found found = search.search(start);
        List<TimedRenderer.Timed> chosen = new ArrayList<>();
        for (int i = 0; i < start.length; i++) {
            TimedRenderer.Timed t = renders.get(i + " " + found.samples()[i]);
            chosen.add(new TimedRenderer.Timed(t.image(), t.settings(), found.seconds()[i], t.cpu(), t.sampling()));
        }
        keep(chosen);
    }

    private List<MeasuredCosts> best() {
        List<MeasuredCosts> best = new ArrayList<>();
        for (String method : session.settings.methods()) {
            List<MeasuredCosts> all = session.costs(method).stream()
                    .filter(r -> !r.configuration().grid())
                    .toList();
            Configuration configuration = TradeAnalysis.fastest(all, VISIBLE)
                    .map(CostEstimate::configuration)
                    .orElse(Configuration.ofScene(session.settings, method));
            best.add(session.costs(configuration));
        }
        return best;
    }

    /** The shortest time in which a method reaches a visible error, but long enough that fixed costs do not dominate. */
    private static double seconds(List<MeasuredCosts> costs) {
        double visible = costs.stream()
                .flatMap(r -> r.forError(VISIBLE).stream())
                .mapToDouble(n -> n.wall().median())
                .min()
                .orElse(0);
        double start = costs.stream()
                .mapToDouble(r -> r.points().get(0).wall().low())
                .max()
                .orElse(0);
        return Math.max(visible, FIXED_COST * start);
    }

    private void keep(List<TimedRenderer.Timed> renders) throws IOException {
        Image reference = session.reference().image();
        List<TradeRun> runs = session.record(TradeRun.EQUAL_TIME, renders);
        int gain = EqualTimeComparison.gain(runs, session.reference().variance());
        for (int i = 0; i < runs.size(); i++) {
            Image image = renders.get(i).image();
            String method = runs.get(i).method();
            ImageFiles.writePng(image, session.folder.file(EqualTimeComparison.pictureName(method)));
            ImageFiles.writePng(
                    HeatMap.withScale(Flip.between(image.toDisplay(), reference.toDisplay())),
                    session.folder.file(EqualTimeComparison.flipName(method)));
            ImageFiles.writePng(
                    difference(image, reference, gain),
                    session.folder.file(EqualTimeComparison.differenceName(method)));
        }
    }

    private static Image difference(Image a, Image b, int gain) {
        float[] rgb = a.toDisplay().toArray();
        float[] other = b.toDisplay().toArray();
        for (int i = 0; i < rgb.length; i++) {
            rgb[i] = Math.min(gain * Math.abs(rgb[i] - other[i]), 1);
        }
        return new Image(a.width(), a.height(), rgb);
    }
}
