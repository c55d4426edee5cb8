package enlightenment.view.frame;

import java.util.ArrayList;
import java.util.List;

/**
 * The estimated error of a picture at a time, one point of the convergence curve.
 *
 * @param seconds since the change that the picture shows, greater than 0
 * @param samples samples per pixel
 * @param rmse estimated root mean square error, in displayed units 0..1
 * @param exposure the exposure in stops that the displayed units refer to
 */
public record ErrorPoint(double seconds, int samples, double rmse, double exposure) {
    /** Points nearer than this ratio of their times are merged: they coincide on a logarithmic axis. */
    private static final double DISTINCT = 1.02;

    /** The points with a later one appended; at one exposure their number grows with the logarithm of time. */
    public static List<ErrorPoint> with(List<ErrorPoint> points, ErrorPoint next) {
        List<ErrorPoint> all = new ArrayList<>(points);
        int last = all.size() - 1;
        // The last point is always kept, and gives way to the next where it was too near to the one before it.
        if (last >= 1
                && all.get(last).exposure() == next.exposure()
                && all.get(last).seconds() < DISTINCT * all.get(last - 1).seconds()) {
            all.remove(last);
        }
        all.add(next);
        return List.copyOf(all);
    }
}
