package enlightenment.method.cluster;

/** What an effort costs, as the surveys of some blocks tell. */
public interface EffortCost {
    /**
     * The largest effort that costs at most this many samples per pixel, as far as the blocks tell; at least the smallest one,
     * whatever it costs.
     *
     * @throws java.util.concurrent.CancellationException if it is cancelled before that is known
     */
    double effort(double samples);
}
