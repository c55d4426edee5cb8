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
 * @param difference by how much each number of it differs from the reference, times {@code gain}
 * @param gain what makes the differences visible; the same for all methods
 */
public record EqualTime(TradeRun run, Image image, Image difference, int gain) {
    /** An error that can be seen. */
    private static final double VISIBLE = 0.02;

    private static final double CLEAR = 0.2;
    private static final int MOST_GAIN = 256;
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
        int gain = gain(runs.stream()
                .mapToDouble(r -> r.error(session.reference().variance()))
                .max()
                .orElse(1));
        List<EqualTime> pictures = new ArrayList<>();
        for (int i = 0; i < runs.size(); i++) {
            Image image = renders.get(i).image();
            Image map =
                    HeatMap.withScale(Flip.between(image, session.reference().image()));
            String method = runs.get(i).method();
            ImageFiles.writePng(image, session.folder.file("equal-time-" + method + ".png"));
            ImageFiles.writePng(map, session.folder.file("equal-time-" + method + "-flip.png"));
            Image difference = difference(image, session.reference().image(), gain);
            ImageFiles.writePng(difference, session.folder.file("equal-time-" + method + "-error.png"));
            pictures.add(new EqualTime(runs.get(i), image, difference, gain));
        }
        return pictures;
    }

    /** A power of two that lifts an error of this size to about a fifth of white. */
    private static int gain(double error) {
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
