package enlightenment.render;

import enlightenment.classic.cluster.ClusterStatistics;
import enlightenment.frame.SceneFrame;
import enlightenment.math.ExactPoint;
import enlightenment.numeric.Scale;
import enlightenment.sampling.RunningStatistics;
import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.List;

/**
 * A ray cluster as the paper describes it: rays that pass close to each other through the window and end on the same surface
 * and light, with one distribution for each coordinate of their three points. Rays whose light point turned out to be hidden
 * are not valid and do not count in the distributions.
 *
 * @param x first column of the block of pixels
 * @param y first row of the block of pixels
 * @param surface number of the last surface; the same as in the auxiliary image of objects
 * @param light index of the light in the scene
 * @param bounces how many mirrors and glass surfaces the rays met before
 * @param tried rays that were tried
 * @param valid rays whose light point was visible
 * @param gain how many times smaller proposals were expected to make the variance of a light point; 1 where none were used
 * @param distributions of the coordinates, in the scene's units: {@link #COORDINATES} names them; empty without valid rays
 */
public record RayCluster(
        int x,
        int y,
        int surface,
        int light,
        int bounces,
        long tried,
        long valid,
        double gain,
        List<Coordinate> distributions) {
    /** P is the point on the window, S that on the surface, L that on the light. */
    public static final List<String> COORDINATES = List.of("Px", "Py", "Pz", "Sx", "Sy", "Sz", "Lx", "Ly", "Lz");

    /**
     * How a coordinate is distributed.
     *
     * @param mean its mean
     * @param deviation its standard deviation
     */
    public record Coordinate(double mean, double deviation) {}

    static RayCluster of(ClusterStatistics record, SceneFrame frame) {
        List<Coordinate> distributions = new ArrayList<>();
        long valid = record.coordinate(0).count();
        for (int k = 0; k < ClusterStatistics.COORDINATES && valid > 0; k++) {
            RunningStatistics s = record.coordinate(k);
            double mean = originComponent(frame.origin(), k % 3) + Scale.scalb(s.mean(), frame.exponent());
            distributions.add(new Coordinate(mean, Scale.scalb(s.standardDeviation(), frame.exponent())));
        }
        return new RayCluster(
                record.blockX,
                record.blockY,
                record.surface,
                record.light,
                record.bounces,
                record.tried(),
                valid,
                record.gain(),
                List.copyOf(distributions));
    }

    private static double originComponent(ExactPoint origin, int axis) {
        BigDecimal c = axis == 0 ? origin.x() : axis == 1 ? origin.y() : origin.z();
        return c.doubleValue();
    }
}
