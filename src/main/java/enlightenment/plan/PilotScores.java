package enlightenment.plan;

import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.RenderSettings;
import java.util.Arrays;
import java.util.List;
import java.util.Map;

/**
 * Scores methods by small pictures that each made with several seeds. The spread of a method's pictures tells its variance, but not that
 * of paths so rare that it found none: so a method is charged for light that the guard found and it did not.
 */
final class PilotScores {
    /** Standard deviations within which a difference may be chance. */
    private static final double CHANCE = 3;

    private final int width;
    private final int height;
    private final int samples;

    /** By method, its pictures. */
    private final Map<BuiltInMethod, List<PilotPicture>> pictures;

    /** Of the guard. */
    private final List<PilotPicture> guard;

    private final List<PilotCell> cells;
    private final double[] scale;

    /**
     * @param samples camera samples per pixel of each picture
     * @param guard the method whose light all others must find, one of these
     */
    PilotScores(
            int width, int height, int samples, Map<BuiltInMethod, List<PilotPicture>> pictures, BuiltInMethod guard) {
        this.width = width;
        this.height = height;
        this.samples = samples;
        this.pictures = pictures;
        this.guard = pictures.get(guard);
        cells = PilotCell.of(List.of(new RenderSettings.Crop(0, 0, width, height)));
        scale = PilotScale.of(pictures.values(), cells);
    }

    /** The score of a method that has pictures. */
    PilotScore of(BuiltInMethod method) {
        List<PilotPicture> mine = pictures.get(method);
        double[] variance = variance(mine);
        double all = (double) samples * width * height;
        double cost = mine.stream()
                        .mapToDouble(picture -> PilotCosts.of(method, picture.counts()))
                        .sum()
                / (all * mine.size());
        return new PilotScore(
                method,
                PilotSpread.relative(variance, scale) * samples,
                PilotSpread.uncertainty(variance, scale) * samples,
                mine == guard ? 0 : missed(mine),
                cost);
    }

    /** The share of a method's variance that its camera samples have, and not its light paths; 1 if there is none. */
    double shareOfTiles(BuiltInMethod method) {
        List<PilotPicture> mine = pictures.get(method);
        double tiles = PilotSpread.relative(PilotSpread.variance(mine, PilotPicture::tiles), scale);
        double splats = PilotSpread.relative(PilotSpread.variance(mine, PilotPicture::splats), scale);
        return tiles + splats > 0 ? tiles / (tiles + splats) : 1;
    }

    /** Camera samples and light paths are independent. */
    private static double[] variance(List<PilotPicture> of) {
        double[] tiles = PilotSpread.variance(of, PilotPicture::tiles);
        double[] splats = PilotSpread.variance(of, PilotPicture::splats);
        Arrays.setAll(tiles, i -> tiles[i] + splats[i]);
        return tiles;
    }

    /**
     * A lower bound of the variance of a sample that light which was not found brings: paths that bring m to the mean of a cell, and of
     * which N samples had none, have a probability of about 1/N at most, and a second moment of at least m² N.
     */
    private double missed(List<PilotPicture> mine) {
        double[] found = PilotSpread.mean(mine);
        double[] there = PilotSpread.mean(guard);
        double[] myVariance = variance(mine);
        double[] itsVariance = variance(guard);
        double sum = 0;
        for (PilotCell cell : cells) {
            for (int band = 0; band < 3; band++) {
                Difference d = new Difference();
                for (int i : cell.entries(band)) {
                    double ofMeans = myVariance[i] / mine.size() + itsVariance[i] / guard.size();
                    d.add(there[i] - found[i], ofMeans, PilotSpread.ratio(1, scale[i]));
                }
                sum += d.secondMoment() * samples * mine.size();
            }
        }
        return sum / scale.length;
    }

    /** By how much the light of a method is less than that of the guard, in the pixels of a cell. */
    private static final class Difference {
        private int pixels;
        private double light;
        private double variance;

        /** Sum of the factors that make squares relative. */
        private double factors;

        void add(double difference, double itsVariance, double factor) {
            pixels++;
            light += difference;
            variance += itsVariance;
            factors += factor;
        }

        /** The least second moment of one sample in each of the pixels, relative, of one sample in each of them that was taken. */
        double secondMoment() {
            double mean = Math.max(light - CHANCE * Math.sqrt(variance), 0) / pixels;
            return mean * mean * pixels * factors;
        }
    }
}
