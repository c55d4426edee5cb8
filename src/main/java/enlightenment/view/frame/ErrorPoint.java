package enlightenment.view.frame;

import java.util.ArrayList;
import java.util.List;

/**
 * How exact a picture was at a time.
 *
 * @param seconds since the change that the picture shows, greater than 0
 * @param samples per pixel
 * @param rmse estimated root mean square error, in displayed units 0..1
 * @param exposure in stops for which that is so
 */
public record ErrorPoint(double seconds, int samples, double rmse, double exposure) {
    /** Points nearer to each other than this factor of time are one on a logarithmic curve. */
    private static final double DISTINCT = 1.02;

    /** The points and a later one, in their order; some hundred at most, whatever the number of passes. */
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
