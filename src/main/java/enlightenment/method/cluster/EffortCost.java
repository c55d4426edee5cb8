package enlightenment.method.cluster;

/** The cost of an effort, extrapolated from surveys of some blocks. */
public interface EffortCost {
    /**
     * The largest effort whose estimated cost is at most this many samples per pixel; at least the smallest effort, whatever it costs.
     *
     * @throws java.util.concurrent.CancellationException if it is cancelled before that is known
     */
    double effort(double samples);
}
