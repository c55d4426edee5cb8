package enlightenment.measure;

import enlightenment.image.Flip;
import enlightenment.image.HeatMap;
import enlightenment.image.Image;
import enlightenment.image.ImageFiles;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;

/**
 * A picture that took as long as those of the other methods.
 *
 * @param run how it was made and what it is worth
 * @param image the picture
 * @param errorMap where it differs from the reference, with a scale
 */
public record EqualTime(TradeRun run, Image image, Image errorMap) {
    /** An error that can be seen. */
    private static final double VISIBLE = 0.02;

    private static final double STARTS = 1.5;

    /** One picture for each method, written into the folder as well. */
    static List<EqualTime> make(Session session) throws IOException {
        List<Curve> curves =
                session.settings.methods().stream().map(session::curve).toList();
        if (curves.stream().anyMatch(c -> c.points().isEmpty())) {
            return List.of();
        }
        session.say("pictures at equal time");
        double seconds = seconds(curves);
        List<Meter.Timed> renders = new ArrayList<>();
        for (Curve curve : curves) {
            double samples = Digits.upTwo(curve.samplesIn(seconds));
            renders.add(session.timed(
                    curve.method(), samples, session.settings.base().seed()));
        }
        List<TradeRun> runs = session.record(TradeRun.EQUAL_TIME, renders);
        List<EqualTime> pictures = new ArrayList<>();
        for (int i = 0; i < runs.size(); i++) {
            Image image = renders.get(i).image();
            Image map =
                    HeatMap.withScale(Flip.between(image, session.reference().image()));
            String method = runs.get(i).method();
            ImageFiles.writePng(image, session.folder.file("equal-time-" + method + ".png"));
            ImageFiles.writePng(map, session.folder.file("equal-time-" + method + "-error.png"));
            pictures.add(new EqualTime(runs.get(i), image, map));
        }
        return pictures;
    }

    /** The time in which the quickest method comes down to a visible error, but enough for each to do more than begin. */
    private static double seconds(List<Curve> curves) {
        double visible = curves.stream()
                .flatMap(c -> c.samplesFor(VISIBLE).stream())
                .mapToDouble(Curve.Estimate::wall)
                .min()
                .orElse(0);
        double start = curves.stream()
                .mapToDouble(c -> c.points().get(0).wall().low())
                .max()
                .orElse(0);
        return Math.max(visible, STARTS * start);
    }
}
